// What is open on the screen.
export const ui = $state({ keyMap: false, logIn: false });
