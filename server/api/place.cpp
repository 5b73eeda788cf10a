#include "api/place.hpp"

namespace tuftwave::server {

std::string Place::pointer() const {
    if (parent_ == nullptr) return "";
    std::string pointer = parent_->pointer() + "/";
    if (key_.data() == nullptr) return pointer + std::to_string(index_);
    for (const char c : key_) {
        if (c == '~') {
            pointer += "~0";
        } else if (c == '/') {
            pointer += "~1";
        } else {
            pointer += c;
        }
    }
    return pointer;
}

}  // namespace tuftwave::server
