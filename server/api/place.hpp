#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "api/problem.hpp"

namespace tuftwave::server {

/// Collects what is wrong with a body; reading goes on after a problem, so that a person sees several at once.
class FieldProblems {
  public:
    void add(FieldProblem problem) {
        if (found_.size() < kMost) found_.push_back(std::move(problem));
    }
    bool empty() const { return found_.empty(); }
    std::vector<FieldProblem> take() { return std::move(found_); }

  private:
    static constexpr std::size_t kMost = 16;
    std::vector<FieldProblem> found_;
};

/// Where in the body a value stands. Cheap to make; the pointer is only put together for a problem.
class Place {
  public:
    Place() = default;
    Place(const Place& parent, std::string_view key) : parent_(&parent), key_(key) {}
    Place(const Place& parent, std::size_t index) : parent_(&parent), index_(index) {}

    std::string pointer() const;  ///< RFC 6901

  private:
    const Place* parent_ = nullptr;
    std::string_view key_;
    std::size_t index_ = 0;
};

}  // namespace tuftwave::server
