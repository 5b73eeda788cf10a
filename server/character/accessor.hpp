#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

#include "character/file_value.hpp"

namespace tuftwave::server::character {

/// The numbers of an accessor, read from the file's own binary chunk. Every range is checked when it is opened.
class AccessorView {
  public:
    /// @param index  of an accessor that exists
    /// @return  nothing if its numbers lie elsewhere (another buffer, sparse, compressed) or something is wrong with
    /// it,
    ///          which then stands in the fault of `file`
    static std::optional<AccessorView> open(const FileValue& file, std::size_t index, std::string_view binary);

    std::size_t count() const { return count_; }
    std::size_t width() const { return width_; }  ///< numbers per element: 3 of a VEC3, 16 of a MAT4

    /// One number; from -1 or 0 to 1 where the accessor is normalized. @param element, part  below count(), width()
    double number(std::size_t element, std::size_t part) const;

  private:
    const char* data_ = nullptr;
    std::size_t count_ = 0, width_ = 0, stride_ = 0;
    int component_ = 0;
    bool is_normalized_ = false;
};

}  // namespace tuftwave::server::character
