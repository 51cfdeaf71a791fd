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
	"unreadable": "The file is no text",
	"too_large": "The file is too large",
	"log_in": "Log in first",
	"busy": "The machine is busy, try again"
};
export { error_default as default };
