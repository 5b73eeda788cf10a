#include "http/listener.hpp"

#include <algorithm>
#include <chrono>
#include <new>
#include <thread>
#include <utility>

#include "memory/buffers.hpp"
#include "memory/heap.hpp"

namespace tuftwave::server {
namespace {

constexpr std::uint64_t kDoor = 0;
constexpr auto kTick = std::chrono::milliseconds(50);
constexpr std::size_t kMostTurnedAway = 1'024;  // that wait, to read why

}  // namespace

Listener::Listener(ListenerOptions options, Answerer answerer) : premises_(std::move(options), std::move(answerer)) {
    for (int i = 0; i < std::max(premises_.options.threads, 1); ++i)
        loops_.push_back(std::make_unique<EventLoop>(premises_));
}

std::variant<int, std::string> Listener::bind() {
    auto bound = listen_on(premises_.options.host, premises_.options.port);
    if (auto* error = std::get_if<std::string>(&bound)) return std::move(*error);
    door_ = std::move(std::get<Descriptor>(bound));
    if (!poller_.add(door_.number(), kDoor, {true, false, false})) return "no memory to wait for connections";
    return port_of(door_);
}

void Listener::serve() {
    std::vector<std::thread> threads;
    for (const auto& loop : loops_) threads.emplace_back([&loop] { loop->serve(); });
    let_in();
    for (const auto& loop : loops_) loop->finish();
    for (std::thread& thread : threads) thread.join();
}

void Listener::let_in() {
    while (!stopping_) {
        poller_.wait(kTick, [this](const Event&) {
            while (!stopping_ && accept_one()) {
            }
        });
        memory::free_idle_buffers();
        memory::give_back_free_heap();
    }
    // Whoever has knocked is still let in: a connection that the system has taken would else be reset.
    while (accept_one()) {
    }
    door_.close();
}

/// @return  whether more may be waiting
bool Listener::accept_one() {
    Accepted accepted = accept_from(door_);
    if (accepted.out_of_descriptors) std::this_thread::sleep_for(kTick);  // until somebody goes, nobody can be let in
    if (!accepted.socket.is_open()) return false;
    ++accepted_;
    place(std::move(accepted.socket));
    return true;
}

void Listener::place(Descriptor socket) {
    const std::size_t open = premises_.connections, places = premises_.options.connections;
    const bool is_one_too_many = open >= places;
    if (is_one_too_many) ++turned_away_;
    if (open >= places + kMostTurnedAway) return;
    EventLoop& next = *loops_[next_loop_++ % loops_.size()];
    try {
        next.take_in(std::move(socket), is_one_too_many);
    } catch (const std::bad_alloc&) {  // it is closed
    }
}

void Listener::stop() {
    drain();
    stopping_ = true;
    poller_.wake();
}

Listener::Stats Listener::stats() const {
    return {premises_.connections, accepted_, turned_away_, premises_.body_bytes, premises_.answer_bytes};
}

}  // namespace tuftwave::server
