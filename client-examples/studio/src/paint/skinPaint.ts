/** How skin is painted; tones are darkest first. */
export const kSkin = { tones: ["#e9b3a2", "#f6cfbf", "#fee9dc"], line: "#8a5348", pixels: 1.3, light: [0.45, 0.4, 0.9] } as const;
