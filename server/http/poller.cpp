#include "http/poller.hpp"

#include <sys/epoll.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>

namespace tuftwave::server {
namespace {

constexpr std::uint64_t kWakeId = ~std::uint64_t{0};
constexpr int kEventsAtOnce = 256;

epoll_event to_epoll(const std::uint64_t id, const Interest interest) {
    epoll_event event{};
    if (interest.to_read) event.events |= EPOLLIN;
    if (interest.to_write) event.events |= EPOLLOUT;
    if (interest.to_see_end) event.events |= EPOLLRDHUP;
    event.data.u64 = id;
    return event;
}

}  // namespace

Poller::Poller() : epoll_(::epoll_create1(EPOLL_CLOEXEC)), wake_(::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)) {
    if (!epoll_.is_open() || !wake_.is_open())
        throw std::system_error(errno, std::generic_category(), "no descriptors");
    epoll_event event{};
    event.events = EPOLLIN;
    event.data.u64 = kWakeId;
    if (::epoll_ctl(epoll_.number(), EPOLL_CTL_ADD, wake_.number(), &event) != 0)
        throw std::system_error(errno, std::generic_category(), "no memory for epoll");
}

bool Poller::add(const int socket, const std::uint64_t id, const Interest interest) {
    epoll_event event = to_epoll(id, interest);
    return ::epoll_ctl(epoll_.number(), EPOLL_CTL_ADD, socket, &event) == 0;
}

void Poller::change(const int socket, const std::uint64_t id, const Interest interest) {
    epoll_event event = to_epoll(id, interest);
    ::epoll_ctl(epoll_.number(), EPOLL_CTL_MOD, socket, &event);
}

void Poller::wait(const std::chrono::milliseconds patience, const std::function<void(const Event&)>& tell) {
    std::array<epoll_event, kEventsAtOnce> events;
    const int count = ::epoll_wait(epoll_.number(), events.data(), kEventsAtOnce, static_cast<int>(patience.count()));
    for (int i = 0; i < count; ++i) {
        const auto& [bits, data] = events[static_cast<std::size_t>(i)];
        if (data.u64 == kWakeId) {
            std::uint64_t times = 0;
            [[maybe_unused]] const ssize_t got = ::read(wake_.number(), &times, sizeof times);
            continue;
        }
        tell({data.u64, (bits & EPOLLIN) != 0, (bits & EPOLLOUT) != 0, (bits & EPOLLRDHUP) != 0,
              (bits & (EPOLLERR | EPOLLHUP)) != 0});
    }
}

void Poller::wake() {
    const std::uint64_t one = 1;
    [[maybe_unused]] const ssize_t put = ::write(wake_.number(), &one, sizeof one);
}

}  // namespace tuftwave::server
