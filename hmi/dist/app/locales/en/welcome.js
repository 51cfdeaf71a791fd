// src/locales/en/welcome.json
var welcome_default = {
	"title": "Welcome",
	"machine": "{machine}, speaks {dialect}",
	"command": "One screen is in command at a time; the others watch. Hand over with the button at the top.",
	"stop": "Reset and emergency stop work from every screen at any time.",
	"keys": "Keys of the machine act as long as they are held. Press ? for those of the keyboard.",
	"watch": "Only watch",
	"start": "Take command"
};
export { welcome_default as default };
