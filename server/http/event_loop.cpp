#include "http/event_loop.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <list>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <variant>
#include <vector>

#include "http/connection.hpp"
#include "http/debt.hpp"
#include "http/mailbox.hpp"
#include "http/poller.hpp"
#include "http/sockets.hpp"

namespace tuftwave::server {
namespace {

using Clock = Connection::Clock;
using Phase = Connection::Phase;

constexpr auto kTick = std::chrono::milliseconds(50), kNoTime = std::chrono::milliseconds(0);
constexpr std::size_t kRequestsPerConnection = 10'000;
constexpr std::size_t kHeadPiece = 16 * 1024, kBodyPiece = 64 * 1024;
constexpr int kPiecesAtOnce = 8;  // of one connection, then it is the next one's turn
// Of each body and each answer: small ones go on when large ones have used the budget up.
constexpr std::size_t kFreeBytes = 64 * 1024;
// Bytes that all connections and one of them may send before it is the next one's turn.
constexpr std::size_t kSentInARound = 16 * 1024 * 1024, kLeastSent = 32 * 1024, kMostSent = 1024 * 1024;
// Bytes that the system keeps unsent of all their answers and of one; of smaller ones all.
constexpr std::size_t kUnsentOfAll = 64 * 1024 * 1024, kLeastUnsent = 64 * 1024, kMostUnsent = 2 * 1024 * 1024;

}  // namespace

/// All but take_in() and finish() belongs to the thread that serves.
class EventLoop::Connections {
  public:
    explicit Connections(Premises& premises) : premises_(premises) {}
    ~Connections() { mailbox_->close(); }

    void take_in(Descriptor socket, const bool is_one_too_many) {
        std::list<Letter> letter;
        letter.push_back({0, {}, is_one_too_many, std::move(socket)});
        ++premises_.connections;
        mailbox_->post(letter);
    }

    void finish() {
        is_finishing_ = true;
        poller_.wake();
    }

    void serve() {
        auto next_tick = Clock::now();
        for (bool is_last_round = false; !is_last_round || !connections_.empty();) {
            is_last_round = is_finishing_;      // whoever was taken in before is in the mailbox
            if (is_last_round) read_letters();  // and is heard before idle connections go
            poller_.wait(mailbox_->may_sleep() ? kTick : kNoTime, [this](const Event& event) {
                mailbox_->stay_awake();
                on_event(event);
                read_letters();  // at once, so that what was made without a worker is counted before more is made
            });
            read_letters();
            if (Clock::now() < next_tick && !is_last_round) continue;
            guarded([&] { close_what_is_due(is_last_round); });
            next_tick = Clock::now() + kTick;
        }
    }

  private:
    // Connections come and go

    void welcome(Letter& letter) {
        Connection* added = nullptr;
        guarded([&] { added = add(std::move(letter.newcomer)); });
        if (added == nullptr) --premises_.connections;
        if (added != nullptr && letter.closes && !guarded([&] { refuse(*added, 503); })) close(*added);
    }

    /// @return  nothing if the system refuses
    Connection* add(Descriptor socket) {
        const std::uint64_t id = ++last_id_;
        auto made = std::make_unique<Connection>(std::move(socket), id);
        if (!poller_.add(made->socket(), id, kReads)) return nullptr;
        made->interest = kReads;
        return connections_.emplace(id, std::move(made)).first->second.get();
    }

    /// An answer that is still being made keeps the connection's place, since it keeps its memory.
    void close(Connection& connection) {
        connection.close();
        premises_.answer_bytes -= connection.held();
        if (connection.phase() == Phase::kAnswering && !connection.is_gone) {
            connection.is_gone = true;
            connection.work.request_stop();
            return;
        }
        charge(connection, 0);
        connections_.erase(connection.id);
        --premises_.connections;
    }

    // What a connection sends

    void on_event(const Event& event) {
        const auto found = connections_.find(event.id);
        if (found == connections_.end() || found->second->is_gone) return;
        Connection& connection = *found->second;
        if (!guarded([&] { on_event(connection, event); })) close(connection);
    }

    void on_event(Connection& connection, const Event& event) {
        if (event.is_broken) return close(connection);
        switch (connection.phase()) {
            case Phase::kReading:
                return read(connection);
            case Phase::kAnswering:  // a client that closes its side has gone: what it asked for is for nobody
                if (event.has_peer_closed) return close(connection);
                return look_for(connection, kOnlyTheEnd);
            case Phase::kWriting:
                if (!event.can_write) return look_for(connection, kWrites);
                if (write(connection)) resume(connection);
                return;
            case Phase::kLingering:
                if (!connection.drop_input()) close(connection);
        }
    }

    void read(Connection& connection) {
        for (int i = 0; i < kPiecesAtOnce && connection.phase() == Phase::kReading; ++i) {
            const RequestReader& reader = connection.reader;
            const std::size_t piece =
                reader.is_in_body() ? std::clamp<std::size_t>(reader.body_bytes_left(), 1, kBodyPiece) : kHeadPiece;
            const std::string_view bytes = connection.receive(std::span(buffer_).first(piece));
            if (connection.has_ended()) return close(connection);
            if (bytes.empty() || !go_on(connection, bytes)) return;
            if (bytes.size() < piece) return;  // there is no more
        }
    }

    void resume(Connection& connection) {
        const std::string kept = connection.take_kept();
        if (!kept.empty()) go_on(connection, kept);
    }

    /// Goes on as far as these bytes reach. @return  false if the connection is closed
    bool go_on(Connection& connection, std::string_view bytes) {
        while (connection.phase() == Phase::kReading) {
            if (connection.is_idle()) connection.restart_clock();
            bool is_open = true;
            switch (connection.reader.take(bytes)) {
                case RequestReader::Step::kWantsMore:
                    return count_body(connection);
                case RequestReader::Step::kHead:
                    is_open = on_head(connection, bytes);
                    break;
                case RequestReader::Step::kRequest:
                    hand_over(connection);
                    break;
                case RequestReader::Step::kRefused:
                    return refuse(connection, connection.reader.refusal());
            }
            if (!is_open) return false;
        }
        if (connection.phase() != Phase::kLingering) connection.keep(bytes);
        return true;
    }

    /// @param bytes  what came behind the head; shortened by a body that is not wanted
    /// @return  false if the connection is closed
    bool on_head(Connection& connection, std::string_view& bytes) {
        const RequestHead& head = connection.reader.head();
        const bool has_more = !bytes.empty(), is_whole = !head.is_chunked && head.length <= bytes.size();
        std::variant<Admission, Response> verdict = premises_.answerer.admit(head.request, is_whole);
        if (auto* early = std::get_if<Response>(&verdict)) {
            const std::string method = head.request.method;
            const bool closes = !is_whole || head.wants_close;
            if (is_whole) bytes.remove_prefix(static_cast<std::size_t>(head.length));
            connection.reader.skip_body();
            return answer(connection, method, std::move(*early), closes);
        }
        connection.admission = std::get<Admission>(std::move(verdict));
        connection.reader.allow_body(connection.admission.most_body_bytes);
        connection.restart_clock();
        const bool waits = head.expects_continue && head.has_body() && !has_more && connection.reader.refusal() == 0;
        if (!waits || connection.send_at_once("HTTP/1.1 100 Continue\r\n\r\n")) return true;
        close(connection);
        return false;
    }

    /// Keeps to the budget of all bodies. @return  false if the connection is closed
    bool count_body(Connection& connection) {
        charge(connection, connection.reader.body_bytes());
        if (premises_.body_bytes <= options_.body_memory || connection.body_bytes <= kFreeBytes) return true;
        return refuse(connection, 503);
    }

    void charge(Connection& connection, const std::size_t bytes) {
        premises_.body_bytes += bytes - connection.body_bytes;
        connection.body_bytes = bytes;
    }

    void hand_over(Connection& connection) {
        const RequestHead& head = connection.reader.head();
        const bool closes = head.wants_close || ++connection.requests >= kRequestsPerConnection;
        const auto debt = std::make_shared<Debt>(mailbox_, premises_.library, premises_.draining, connection.id,
                                                 head.request.method, closes);
        charge(connection, connection.reader.body_bytes());
        connection.work = std::stop_source();
        connection.begin_answering();
        const Admission admission = std::move(connection.admission);
        try {
            admission.answer(connection.reader.take_request(), connection.work,
                             [debt](Response answer) { debt->pay(std::move(answer)); });
        } catch (...) {  // what it says is for us, never for a client
            debt->pay(premises_.answerer.refuse(500));
        }
    }

    // What it gets

    void read_letters() {
        for (Letter& letter : mailbox_->collect()) {
            if (letter.newcomer.is_open()) {
                welcome(letter);
                continue;
            }
            const auto found = connections_.find(letter.connection);
            if (found == connections_.end()) continue;
            Connection& connection = *found->second;
            charge(connection, 0);
            if (!guarded([&] { deliver(connection, letter); })) close(connection);
        }
    }

    void deliver(Connection& connection, Letter& letter) {
        if (connection.is_gone || letter.message.head.empty()) return forget(connection);
        const std::size_t size = letter.message.memory(), held = premises_.answer_bytes.fetch_add(size);
        const bool is_too_much = size > kFreeBytes && held > 0 && held + size > options_.answer_memory;
        if (is_too_much) premises_.answer_bytes -= size;
        const bool is_open =
            is_too_much ? refuse(connection, 503) : send(connection, std::move(letter.message), letter.closes);
        if (is_open) resume(connection);
    }

    void forget(Connection& connection) {
        connection.is_gone = true;
        close(connection);
    }

    /// @return  false if the connection is closed
    bool refuse(Connection& connection, const int status) {
        const bool is_head = connection.phase() == Phase::kReading && connection.reader.head().request.method == "HEAD";
        return answer(connection, is_head ? "HEAD" : "GET", premises_.answerer.refuse(status), true);
    }

    bool answer(Connection& connection, const std::string& method, Response answer, const bool closes) {
        const bool is_last = closes || *premises_.draining;
        Message message = premises_.library->message(method, std::move(answer), is_last);
        charge(connection, 0);
        premises_.answer_bytes += message.memory();
        return send(connection, std::move(message), is_last);
    }

    /// @param message  counted among the answers
    bool send(Connection& connection, Message message, const bool closes) {
        connection.begin_writing(std::move(message), closes);
        if (connection.unsent() > kLeastUnsent)
            keep_unsent(connection.socket(),
                        std::clamp(kUnsentOfAll / premises_.connections, kLeastUnsent, kMostUnsent));
        return write(connection);
    }

    /// @return  false if the connection is closed
    bool write(Connection& connection) {
        const std::size_t before = connection.held();
        // However many take a large answer, all of them together hold up who asks for a small one for some
        // milliseconds.
        const std::size_t share = kSentInARound / connections_.size();
        const Connection::Sent sent = connection.send(std::clamp(share, kLeastSent, kMostSent));
        premises_.answer_bytes -= before - connection.held();
        if (sent == Connection::Sent::kFailed) {
            close(connection);
            return false;
        }
        if (sent == Connection::Sent::kAll && connection.closes()) connection.begin_lingering();
        look_for(connection, sent == Connection::Sent::kSome ? kWrites : kReads);
        return true;
    }

    void look_for(Connection& connection, const Interest interest) {
        if (connection.interest == interest) return;
        connection.interest = interest;
        poller_.change(connection.socket(), connection.id, interest);
    }

    // What takes too long

    /// The fewer places are left, the sooner a connection that does nothing has to go.
    std::chrono::milliseconds idle_patience() const {
        const std::size_t open = premises_.connections, places = options_.connections;
        if (open * 10 >= places * 9) return options_.patience.idle / 15;
        if (open * 4 >= places * 3) return options_.patience.idle / 5;
        return options_.patience.idle;
    }

    void close_what_is_due(const bool is_last_round) {
        const auto now = Clock::now();
        const std::chrono::milliseconds idle = is_last_round ? kNoTime : idle_patience();
        std::vector<Connection*> due;
        for (const auto& [id, connection] : connections_) {
            if (now >= connection->due(options_.patience, idle)) due.push_back(connection.get());
        }
        for (Connection* connection : due) {
            const bool is_slow = connection->phase() == Phase::kReading && !connection->is_idle();
            if (!is_slow || !guarded([&] { refuse(*connection, 408); })) close(*connection);
        }
    }

    /// @return  false if there was no memory for it
    template <class Act>
    static bool guarded(const Act& act) {
        try {
            act();
            return true;
        } catch (...) {
            return false;
        }
    }

    static constexpr Interest kReads{true, false, true}, kWrites{false, true, false}, kOnlyTheEnd{false, false, true};

    Premises& premises_;
    const ListenerOptions& options_ = premises_.options;
    Poller poller_;
    const std::shared_ptr<Mailbox> mailbox_ = std::make_shared<Mailbox>(poller_);
    std::atomic<bool> is_finishing_ = false;
    std::unordered_map<std::uint64_t, std::unique_ptr<Connection>> connections_;
    std::uint64_t last_id_ = 0;
    std::array<char, kBodyPiece> buffer_;
};

EventLoop::EventLoop(Premises& premises) : connections_(std::make_unique<Connections>(premises)) {}

EventLoop::~EventLoop() = default;

void EventLoop::take_in(Descriptor socket, const bool is_one_too_many) {
    connections_->take_in(std::move(socket), is_one_too_many);
}

void EventLoop::finish() { connections_->finish(); }

void EventLoop::serve() { connections_->serve(); }

}  // namespace tuftwave::server
