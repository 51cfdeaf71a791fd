// src/locales/en/rights.json
var rights_default = {
	"title": "Rights",
	"level": "Level {level}",
	"level_label": "Level",
	"level_0": "Not logged in",
	"level_1": "System maker",
	"level_2": "Machine builder",
	"level_3": "System set-up",
	"level_4": "End user",
	"level_5": "Operator",
	"log_in": "Log in",
	"log_out": "Log out",
	"logged_in": "Logged in: {level}",
	"password": "Password",
	"wrong": "That is not the password of this level.",
	"too_often": "Too many attempts. Wait a minute.",
	"gate": "Log in first",
	"gate_text": "From this computer the machine is seen and operated only after a log-in."
};
export { rights_default as default };
