import { fileName } from "../../../client-examples/studio/src/take_away/fileName";

test.each([
  ["fringe", "fringe"],
  ["  前髪 ver. 2 ", "前髪 ver. 2"],
  ["a/b\\c:d*e?f\"g<h>i|j", "a_b_c_d_e_f_g_h_i_j"],
  ["../../etc", "_.._etc"],
  ["...", "hair"],
  ["", "hair"],
  ["x".repeat(100), "x".repeat(60)],
])("%j is called %j", (name, file) => expect(fileName(name)).toBe(file));
