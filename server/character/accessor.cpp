#include "character/accessor.hpp"

#include <cstdint>
#include <cstring>
#include <limits>

namespace tuftwave::server::character {
namespace {

constexpr std::size_t kMost = 0xFFFFFFFF;  // bytes of a GLB

/// Bytes of a component type, 0 if there is no such type.
std::size_t bytes_of(int component) {
    switch (component) {
        case 5120:
        case 5121:
            return 1;
        case 5122:
        case 5123:
            return 2;
        case 5125:
        case 5126:
            return 4;
        default:
            return 0;
    }
}

/// Numbers per element of a type, 0 if there is no such type or its columns are padded.
std::size_t width_of(const std::string& type) {
    if (type == "SCALAR") return 1;
    if (type == "VEC2") return 2;
    if (type == "VEC3") return 3;
    if (type == "VEC4") return 4;
    return type == "MAT4" ? 16 : 0;
}

template <class T>
double number_from(const char* at, bool is_normalized) {
    T number;
    std::memcpy(&number, at, sizeof number);
    const auto value = static_cast<double>(number);
    if (!is_normalized || !std::numeric_limits<T>::is_integer) return value;
    const double share = value / static_cast<double>(std::numeric_limits<T>::max());
    return share < -1 ? -1 : share;
}

}  // namespace

std::optional<AccessorView> AccessorView::open(const FileValue& file, std::size_t index, std::string_view binary) {
    const FileValue accessor = file["accessors"].at(index), views = file["bufferViews"];
    AccessorView opened;
    opened.component_ = static_cast<int>(accessor["componentType"].whole(0xFFFF).value_or(0));
    opened.width_ = width_of(accessor["type"].text());
    opened.count_ = accessor["count"].whole(kMost).value_or(0);
    opened.is_normalized_ = accessor["normalized"].flag();
    const std::optional<int> view_index = accessor["bufferView"].index(views.size());
    if (bytes_of(opened.component_) == 0) accessor["componentType"].refuse(Fault::Kind::kOutOfRange, "5120 to 5126");
    if (opened.width_ == 0 || opened.count_ == 0 || !view_index || accessor["sparse"].exists()) return {};

    const FileValue view = views.at(static_cast<std::size_t>(*view_index));
    if (view["buffer"].whole(kMost).value_or(0) != 0 || view["extensions"].exists()) return {};
    const std::size_t view_start = view["byteOffset"].whole(kMost).value_or(0);
    const std::size_t view_bytes = view["byteLength"].whole(kMost).value_or(0);
    const std::size_t start = accessor["byteOffset"].whole(kMost).value_or(0);
    const std::size_t element = bytes_of(opened.component_) * opened.width_;
    opened.stride_ = view["byteStride"].whole(252).value_or(element);
    if (element == 0 || opened.stride_ < element) return {};
    if (view_start > binary.size() || view_bytes > binary.size() - view_start) {
        view.refuse(Fault::Kind::kOutOfRange,
                    "a part of the file's " + std::to_string(binary.size()) + " binary bytes");
        return {};
    }
    // 32-bit numbers all, so that nothing overflows in 64.
    if (start + opened.stride_ * (opened.count_ - 1) + element > view_bytes) {
        accessor.refuse(Fault::Kind::kOutOfRange, "a part of its view's " + std::to_string(view_bytes) + " bytes");
        return {};
    }
    opened.data_ = binary.data() + view_start + start;
    return opened;
}

double AccessorView::number(std::size_t element, std::size_t part) const {
    const char* const at = data_ + element * stride_ + part * bytes_of(component_);
    switch (component_) {
        case 5120:
            return number_from<std::int8_t>(at, is_normalized_);
        case 5121:
            return number_from<std::uint8_t>(at, is_normalized_);
        case 5122:
            return number_from<std::int16_t>(at, is_normalized_);
        case 5123:
            return number_from<std::uint16_t>(at, is_normalized_);
        case 5125:
            return number_from<std::uint32_t>(at, is_normalized_);
        default:
            return number_from<float>(at, is_normalized_);
    }
}

}  // namespace tuftwave::server::character
