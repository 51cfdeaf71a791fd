// src/lib/editor/lines.ts
/** The lines of a text, ended in any way that the editor knows. The usual ends, line feeds with or without a carriage
return, are split at much faster than by an expression, which counts in a program of 10 MB. */
function linesOf(text) {
	const lines = text.split("\n");
	if (!text.includes("\r")) return lines;
	const bare = lines.map((line, index) => line.endsWith("\r") && index < lines.length - 1 ? line.slice(0, -1) : line);
	return bare.some((line) => line.includes("\r")) ? text.split(/\r\n?|\n/) : bare;
}
export { linesOf };
