// src/locales/en/error.json
var error_default = {
	"failed": "That did not work",
	"not_in_command": "Take command first",
	"taken": "Somebody else is in command",
	"no_connection": "No connection to the machine",
	"no_machine": "The machine does not answer",
	"no_answer": "The machine gave no answer in time",
	"no_command": "The machine does not know this command",
	"no_object": "The machine could not read this",
	"bad_id": "The machine could not read this",
	"refused": "The machine refused this",
	"unreadable": "The machine could not read this",
	"too_large": "The file is too large",
	"log_in": "Log in first",
	"busy": "The machine is busy, try again",
	"not_text": "The file is no text",
	"too_slow": "The connection was too slow",
	"too_often": "Too many attempts: wait a minute",
	"missing": "The machine does not have this",
	"other_origin": "The machine takes this only from its own page",
	"unknown_host": "The machine does not know itself by this address",
	"line_too_long": "What was sent at once was too long",
	"too_many_connections": "Too many are connected already",
	"logged_out": "You were logged out",
	"dnc_over": "Nothing more of a file is awaited",
	"dnc_foreign": "This is another file than the one that was being sent"
};
export { error_default as default };
