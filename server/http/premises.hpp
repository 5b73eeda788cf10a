#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>

#include "http/answerer.hpp"
#include "http/connection.hpp"
#include "http/library.hpp"

namespace tuftwave::server {

struct ListenerOptions {
    std::string host = "127.0.0.1";
    int port = 0;                                   ///< 0 picks a free one
    std::size_t connections = 64;                   ///< open at once; the next one gets 503
    std::size_t body_memory = 64 * 1024 * 1024;     ///< bytes of all bodies; the first 64 KiB of each are free
    std::size_t answer_memory = 192 * 1024 * 1024;  ///< bytes of all answers until they are taken; as above
    Patience patience{};
    int threads = 1;  ///< that serve connections, each its own ones; at least 1
};

/// What all connections of a listener have in common, whichever thread serves them.
struct Premises {
    Premises(ListenerOptions its_options, Answerer its_answerer)
        : options(std::move(its_options)), answerer(std::move(its_answerer)) {}

    const ListenerOptions options;
    const Answerer answerer;
    const std::shared_ptr<const Library> library = std::make_shared<const Library>();
    const std::shared_ptr<std::atomic<bool>> draining = std::make_shared<std::atomic<bool>>(false);
    std::atomic<std::size_t> connections = 0;                   ///< open now
    std::atomic<std::size_t> body_bytes = 0, answer_bytes = 0;  ///< held now
};

}  // namespace tuftwave::server
