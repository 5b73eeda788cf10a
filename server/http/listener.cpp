#include "http/listener.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "http/debt.hpp"
#include "http/library.hpp"
#include "http/mailbox.hpp"
#include "http/poller.hpp"
#include "memory/buffers.hpp"

namespace tuftwave::server {
namespace {

using Clock = Connection::Clock;
using Phase = Connection::Phase;

constexpr std::uint64_t kDoor = 0;  // the listening socket among the connections
constexpr auto kTick = std::chrono::milliseconds(50), kNoTime = std::chrono::milliseconds(0);
constexpr std::size_t kRequestsPerConnection = 10'000;
constexpr std::size_t kHeadPiece = 16 * 1024, kBodyPiece = 64 * 1024;
constexpr int kPiecesAtOnce = 8;  // of one connection, then it is the next one's turn
// Of each body and each answer: small ones go on when large ones have used the budget up.
constexpr std::size_t kFreeBytes = 64 * 1024;
// Bytes that all connections and one of them may send before it is the next one's turn.
constexpr std::size_t kSentInARound = 16 * 1024 * 1024, kLeastSent = 32 * 1024, kMostSent = 1024 * 1024;
constexpr std::size_t kMostTurnedAway = 1'024;  // that wait, to read why
constexpr std::size_t kAcceptsAtOnce = 256;

}  // namespace

/// All but bind(), drain(), stop() and stats() belongs to the thread that serves.
class Listener::Loop {
  public:
    Loop(ListenerOptions options, Answerer answerer) : options_(std::move(options)), answerer_(std::move(answerer)) {}
    ~Loop() { mailbox_->close(); }

    std::variant<int, std::string> bind() {
        auto bound = listen_on(options_.host, options_.port);
        if (auto* error = std::get_if<std::string>(&bound)) return std::move(*error);
        door_ = std::move(std::get<Descriptor>(bound));
        if (!poller_.add(door_.number(), kDoor, {true, false, false})) return "no memory to wait for connections";
        return port_of(door_);
    }

    void serve() {
        for (auto next_tick = Clock::now(); door_.is_open() || !connections_.empty();) {
            poller_.wait(mailbox_->may_sleep() ? kTick : kNoTime, [this](const Event& event) {
                mailbox_->stay_awake();
                on_event(event);
                deliver_answers();  // at once, so that what was made without a worker is counted before more is made
            });
            deliver_answers();
            if (stopping_) close_the_door();
            if (Clock::now() < next_tick && !stopping_) continue;
            guarded([this] { close_what_is_due(); });
            memory::free_idle_buffers();
            wait_at_the_door(true);
            next_tick = Clock::now() + kTick;
        }
    }

    void drain() { *draining_ = true; }

    void stop() {
        drain();
        stopping_ = true;
        poller_.wake();
    }

    Stats stats() const { return {open_, accepted_, turned_away_, body_bytes_, answer_bytes_}; }

  private:
    // Connections come and go

    /// @return  whether more may be waiting
    bool accept_some() {
        for (std::size_t i = 0; i < kAcceptsAtOnce; ++i) {
            Accepted accepted = accept_from(door_);
            if (accepted.out_of_descriptors) wait_at_the_door(false);
            if (!accepted.socket.is_open()) return false;
            ++accepted_;
            guarded([&] { welcome(std::move(accepted.socket)); });
        }
        return true;
    }

    void welcome(Descriptor socket) {
        const bool is_one_too_many = connections_.size() >= options_.connections;
        if (is_one_too_many) ++turned_away_;
        if (connections_.size() >= options_.connections + kMostTurnedAway) return;
        const std::uint64_t id = ++last_id_;
        if (!poller_.add(socket.number(), id, kReads)) return;
        auto made = std::make_unique<Connection>(std::move(socket), id);
        made->interest = kReads;
        Connection& connection = *connections_.emplace(id, std::move(made)).first->second;
        open_ = connections_.size();
        if (is_one_too_many) refuse(connection, 503);
    }

    /// Without descriptors the door would be knocked at all the time, and nobody could be let in.
    void wait_at_the_door(const bool is_open) {
        if (is_open == is_waiting_ || !door_.is_open()) return;
        is_waiting_ = is_open;
        poller_.change(door_.number(), kDoor, {is_open, false, false});
    }

    /// Whoever has knocked is still let in: a connection that the system has taken would else be reset.
    void close_the_door() {
        if (!door_.is_open()) return;
        while (accept_some()) {
        }
        door_.close();
    }

    /// An answer that is still being made keeps the connection's place, since it keeps its memory.
    void close(Connection& connection) {
        connection.close();
        answer_bytes_ -= connection.held();
        if (connection.phase() == Phase::kAnswering && !connection.is_gone) {
            connection.is_gone = true;
            connection.work.request_stop();
            return;
        }
        charge(connection, 0);
        connections_.erase(connection.id);
        open_ = connections_.size();
    }

    // What a connection sends

    void on_event(const Event& event) {
        if (event.id == kDoor) {
            accept_some();
            return;
        }
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
                    is_open = on_head(connection, !bytes.empty());
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

    /// @return  false if the connection is closed
    bool on_head(Connection& connection, const bool has_more) {
        const RequestHead& head = connection.reader.head();
        std::variant<Admission, Response> verdict = answerer_.admit(head.request);
        if (auto* early = std::get_if<Response>(&verdict)) {
            const std::string method = head.request.method;
            const bool closes = head.has_body() || head.wants_close;
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
        if (body_bytes_ <= options_.body_memory || connection.body_bytes <= kFreeBytes) return true;
        return refuse(connection, 503);
    }

    void charge(Connection& connection, const std::size_t bytes) {
        body_bytes_ += bytes - connection.body_bytes;
        connection.body_bytes = bytes;
    }

    void hand_over(Connection& connection) {
        const RequestHead& head = connection.reader.head();
        const bool closes = head.wants_close || ++connection.requests >= kRequestsPerConnection;
        const auto debt =
            std::make_shared<Debt>(mailbox_, library_, draining_, connection.id, head.request.method, closes);
        charge(connection, connection.reader.body_bytes());
        connection.work = std::stop_source();
        connection.begin_answering();
        const Admission admission = std::move(connection.admission);
        try {
            admission.answer(connection.reader.take_request(), connection.work,
                             [debt](Response answer) { debt->pay(std::move(answer)); });
        } catch (...) {  // what it says is for us, never for a client
            debt->pay(answerer_.refuse(500));
        }
    }

    // What it gets

    void deliver_answers() {
        for (Letter& letter : mailbox_->collect()) {
            const auto found = connections_.find(letter.connection);
            if (found == connections_.end()) continue;
            Connection& connection = *found->second;
            charge(connection, 0);
            if (!guarded([&] { deliver(connection, letter); })) close(connection);
        }
    }

    void deliver(Connection& connection, Letter& letter) {
        if (connection.is_gone || letter.message.head.empty()) return forget(connection);
        const std::size_t size = letter.message.memory();
        const bool is_too_much =
            size > kFreeBytes && answer_bytes_ > 0 && answer_bytes_ + size > options_.answer_memory;
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
        return answer(connection, is_head ? "HEAD" : "GET", answerer_.refuse(status), true);
    }

    bool answer(Connection& connection, const std::string& method, Response answer, const bool closes) {
        const bool is_last = closes || *draining_;
        return send(connection, library_->message(method, std::move(answer), is_last), is_last);
    }

    bool send(Connection& connection, Message message, const bool closes) {
        charge(connection, 0);
        answer_bytes_ += message.memory();
        connection.begin_writing(std::move(message), closes);
        return write(connection);
    }

    /// @return  false if the connection is closed
    bool write(Connection& connection) {
        const std::size_t before = connection.held();
        // However many take a large answer, all of them together hold up who asks for a small one for some
        // milliseconds.
        const std::size_t share = kSentInARound / connections_.size();
        const Connection::Sent sent = connection.send(std::clamp(share, kLeastSent, kMostSent));
        answer_bytes_ -= before - connection.held();
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
        const std::size_t open = connections_.size(), places = options_.connections;
        if (stopping_) return std::chrono::milliseconds(0);
        if (open * 10 >= places * 9) return options_.patience.idle / 15;
        if (open * 4 >= places * 3) return options_.patience.idle / 5;
        return options_.patience.idle;
    }

    void close_what_is_due() {
        const auto now = Clock::now();
        const std::chrono::milliseconds idle = idle_patience();
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

    const ListenerOptions options_;
    const Answerer answerer_;
    Poller poller_;
    const std::shared_ptr<Mailbox> mailbox_ = std::make_shared<Mailbox>(poller_);
    const std::shared_ptr<const Library> library_ = std::make_shared<const Library>();
    const std::shared_ptr<std::atomic<bool>> draining_ = std::make_shared<std::atomic<bool>>(false);
    std::atomic<bool> stopping_ = false;
    Descriptor door_;
    bool is_waiting_ = true;  // for somebody to knock
    std::unordered_map<std::uint64_t, std::unique_ptr<Connection>> connections_;
    std::uint64_t last_id_ = kDoor;
    std::array<char, kBodyPiece> buffer_;
    std::atomic<std::size_t> open_ = 0, body_bytes_ = 0, answer_bytes_ = 0;
    std::atomic<std::uint64_t> accepted_ = 0, turned_away_ = 0;
};

Listener::Listener(ListenerOptions options, Answerer answerer)
    : loop_(std::make_unique<Loop>(std::move(options), std::move(answerer))) {}

Listener::~Listener() = default;

std::variant<int, std::string> Listener::bind() { return loop_->bind(); }

void Listener::serve() { loop_->serve(); }

void Listener::drain() { loop_->drain(); }

void Listener::stop() { loop_->stop(); }

Listener::Stats Listener::stats() const { return loop_->stats(); }

}  // namespace tuftwave::server
