// What cpp-httplib does by itself: the peer that the service is measured against over HTTP.
//
//   tuftwave_http_peer FILE...      prints its port, then serves on 127.0.0.1 until it is killed
//
//   GET /null              a few bytes, the null handler
//   GET or POST /same/N    the bytes of file N, counted from 0: the same-bytes handler, which sends an answer without
//                          making it. Set up as a good user would: no delay, long keep-alive, threads for everybody,
//                          and a content provider, since set_content() copies.
#include <httplib.h>

#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace {

constexpr std::size_t kThreads = 128;
constexpr std::size_t kRequestsPerConnection = 100'000'000;
constexpr std::size_t kSmall = 64 * 1024;  // below, one copy is cheaper than a provider

std::string content_of(const char* path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

int main(int count, char** words) {
    const std::vector<std::string> files = [&] {
        std::vector<std::string> read;
        for (int i = 1; i < count; ++i) read.push_back(content_of(words[i]));
        return read;
    }();
    httplib::Server server;
    server.new_task_queue = [] { return new httplib::ThreadPool(kThreads); };
    server.set_tcp_nodelay(true);
    server.set_keep_alive_max_count(kRequestsPerConnection);
    server.set_keep_alive_timeout(60);
    server.Get("/null",
               [](const httplib::Request&, httplib::Response& answer) { answer.set_content("alive\n", "text/plain"); });
    const auto same = [&files](const httplib::Request& request, httplib::Response& answer) {
        const std::string& bytes = files.at(std::stoul(request.matches[1]));
        if (bytes.size() < kSmall) return answer.set_content(bytes, "application/octet-stream");
        answer.set_content_provider(bytes.size(), "application/octet-stream",
                                    [&bytes](std::size_t from, std::size_t length, httplib::DataSink& sink) {
                                        return sink.write(bytes.data() + from, length);
                                    });
    };
    server.Get(R"(/same/(\d+))", same);
    server.Post(R"(/same/(\d+))", same);
    std::printf("%d\n", server.bind_to_any_port("127.0.0.1"));
    std::fflush(stdout);
    return server.listen_after_bind() ? 0 : 1;
}
