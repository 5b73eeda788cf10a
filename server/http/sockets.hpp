#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <variant>

namespace tuftwave::server {

/// A file descriptor that is closed with its owner.
class Descriptor {
  public:
    explicit Descriptor(const int number = -1) : number_(number) {}
    ~Descriptor() { close(); }
    Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
    Descriptor& operator=(Descriptor&& other) noexcept {
        std::swap(number_, other.number_);
        return *this;
    }
    int number() const { return number_; }
    bool is_open() const { return number_ >= 0; }
    void close();

  private:
    int number_;
};

/// Takes a port, alone: no other process can listen on it as well.
/// @param port  0 picks a free one
/// @return  a listening socket that does not block, or why there is none
std::variant<Descriptor, std::string> listen_on(const std::string& host, int port);

/// Bytes that the system may keep of an answer before it is their turn to be sent: the more, the less often it has to
/// ask for the next ones, and the more a slow client leaves with it. A hint.
void keep_unsent(int socket, std::size_t most);

/// The port that a socket is bound to.
int port_of(const Descriptor& socket);

/// What came of accepting.
struct Accepted {
    Descriptor socket;                ///< does not block; not open if nobody waits
    bool out_of_descriptors = false;  ///< or of memory: try again later
};
Accepted accept_from(const Descriptor& listening);

}  // namespace tuftwave::server
