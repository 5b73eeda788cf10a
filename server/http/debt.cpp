#include "http/debt.hpp"

#include <utility>

namespace tuftwave::server {

Debt::Debt(std::shared_ptr<Mailbox> mailbox, std::shared_ptr<const Library> library,
           std::shared_ptr<const std::atomic<bool>> draining, const std::uint64_t connection, std::string method,
           const bool closes)
    : mailbox_(std::move(mailbox)),
      library_(std::move(library)),
      draining_(std::move(draining)),
      method_(std::move(method)) {
    letter_.push_back({connection, {}, closes});
}

Debt::~Debt() {
    if (!letter_.empty()) mailbox_->post(letter_);
}

void Debt::pay(Response answer) noexcept {
    if (letter_.empty()) return;
    Letter& letter = letter_.front();
    letter.closes = letter.closes || *draining_;
    try {
        letter.message = library_->message(method_, std::move(answer), letter.closes);
    } catch (...) {  // no memory for the answer: none is sent
        letter.message = {};
    }
    mailbox_->post(letter_);
}

}  // namespace tuftwave::server
