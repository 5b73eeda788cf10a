#pragma once

#include <simdjson.h>

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string_view>

namespace tuftwave::server {

/// A value of a client's JSON, looked at where the parser left it: cheap to copy, and gone with its document.
class JsonValue {
  public:
    JsonValue(const simdjson::dom::element element) : element_(element) {}  // without a word, for loops over items()

    bool is_null() const { return element_.is_null(); }
    bool is_array() const { return element_.is_array(); }
    bool is_object() const { return element_.is_object(); }
    bool is_nested() const { return is_array() || is_object(); }

    std::optional<double> number() const { return as<double>(); }  ///< whole ones as well, the nearest
    std::optional<bool> boolean() const { return as<bool>(); }
    std::optional<std::string_view> text() const { return as<std::string_view>(); }  ///< UTF-8

    /// How much is in an array or an object; 0 for anything else.
    std::size_t size() const { return is_array() ? items().size() : is_object() ? members().size() : 0; }

    /// What an array holds, to be gone through from its beginning. @pre  is_array()
    simdjson::dom::array items() const { return element_.get_array().value_unsafe(); }

    /// What an object holds, as pairs named key and value, in the order sent. @pre  is_object()
    simdjson::dom::object members() const { return element_.get_object().value_unsafe(); }

    /// Whether it is an array of as many numbers as there is room for, and nothing else. @param into  else anything
    template <std::size_t count>
    bool read_numbers(std::array<double, count>& into) const {
        if (!is_array()) return false;
        std::size_t i = 0;
        for (const simdjson::dom::element item : items()) {
            if (i == count || item.get(into[i++]) != simdjson::SUCCESS) return false;
        }
        return i == count;
    }

    /// An object's member of that name; nothing where there is none, or no object.
    std::optional<JsonValue> find(std::string_view name) const;

  private:
    template <class Value>
    std::optional<Value> as() const {
        Value value;
        return element_.get(value) == simdjson::SUCCESS ? std::optional(value) : std::nullopt;
    }

    simdjson::dom::element element_;
};

/// What was parsed. Values in it stay where they are when it is moved.
class JsonDocument {
  public:
    /// @return  nothing for what is no JSON (RFC 8259), and for whole numbers beyond 64 bits and a byte order mark, too
    /// @throws std::bad_alloc
    /// Cost at most 14 bytes of memory per byte of text while it runs and 10 afterwards; of usual requests 4 and 2.
    /// Thread-safe; each thread keeps the buffers of its last small text.
    static std::optional<JsonDocument> parse(std::string_view text);

    JsonValue root() const { return document_->root(); }

  private:
    struct Keep {
        void operator()(simdjson::dom::document* document) const;
    };
    std::unique_ptr<simdjson::dom::document, Keep> document_;
};

}  // namespace tuftwave::server
