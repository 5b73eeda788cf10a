/** Whether a text can be a key at all: 20 to 200 characters of visible ASCII, as the service wants them. */
export function isKey(text: string): boolean {
  return /^[!-~]{20,200}$/.test(text);
}
