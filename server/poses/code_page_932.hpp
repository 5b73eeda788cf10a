#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace tuftwave::server::poses {

/// UTF-8 as code page 932, Windows' Shift_JIS, in which VMD and PMD write names. Our own table, since a system's
/// iconv may lack the code page or have another variant of it.
/// @return  nothing where a character has no code, is a control character, or the text is no UTF-8
std::optional<std::string> to_code_page_932(std::string_view utf8);

}  // namespace tuftwave::server::poses
