/** Colors that anime hair often has. */
export const hairColors: readonly string[] = ["#e8638c", "#d17a52", "#f2c46b", "#8a5a44", "#3a3440", "#8f8ddb", "#4fb0c6", "#6fbf8b", "#d8d6e6"];
