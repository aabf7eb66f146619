// Servers on this computer for tests of channels: what comes is kept, what is answered is chosen.
#ifndef COPPICE_TESTS_ROBOT_APP_ASSISTANCE_LOCAL_SERVER_H_
#define COPPICE_TESTS_ROBOT_APP_ASSISTANCE_LOCAL_SERVER_H_

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/read_until.hpp>
#include <boost/asio/streambuf.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <condition_variable>
#include <functional>
#include <istream>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace coppice::robot::assistance {

/// Serves one connection after the other, each by `Serve`, until it is destroyed.
class LocalServer {
 public:
  using Socket = boost::asio::ip::tcp::socket;

  explicit LocalServer(std::function<void(Socket&)> serve)
      : acceptor_(context_, {boost::asio::ip::address_v4::loopback(), 0}),
        serve_(std::move(serve)),
        thread_([this] { Run(); }) {}

  ~LocalServer() {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      stop_ = true;
      if (current_) {
        boost::system::error_code ignored;
        current_->shutdown(Socket::shutdown_both, ignored);
      }
    }
    boost::asio::io_context context;
    Socket waker(context);  // ends the wait for a connection
    boost::system::error_code ignored;
    waker.connect(acceptor_.local_endpoint(), ignored);
    thread_.join();
  }
  LocalServer(const LocalServer&) = delete;
  LocalServer& operator=(const LocalServer&) = delete;

  std::string port() const { return std::to_string(acceptor_.local_endpoint().port()); }

 private:
  void Run() {
    while (true) {
      Socket socket(context_);
      acceptor_.accept(socket);
      {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (stop_) return;
        current_ = &socket;
      }
      try {
        serve_(socket);
      } catch (const boost::system::system_error&) {  // the other end has gone
      }
      const std::lock_guard<std::mutex> lock(mutex_);
      current_ = nullptr;
      if (stop_) return;
    }
  }

  boost::asio::io_context context_;
  boost::asio::ip::tcp::acceptor acceptor_;
  const std::function<void(Socket&)> serve_;
  std::mutex mutex_;
  Socket* current_ = nullptr;
  bool stop_ = false;
  std::thread thread_;
};

/// Speaks as much SMTP as a client needs. All lines are kept, also those of the messages.
class SmtpServer {
 public:
  /// `refuse`: a command that is answered with 550, for example "RCPT".
  explicit SmtpServer(std::string refuse = {}) : refuse_(std::move(refuse)) {}

  std::string url() const { return "smtp://127.0.0.1:" + server_.port(); }

  std::vector<std::string> lines() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return lines_;
  }
  std::string text() {
    std::string all;
    for (const std::string& line : lines()) all += line + "\n";
    return all;
  }

 private:
  void Serve(LocalServer::Socket& socket) {
    const auto say = [&](const std::string& line) {
      boost::asio::write(socket, boost::asio::buffer(line + "\r\n"));
    };
    say("220 test");
    bool is_data = false;
    boost::asio::streambuf buffer;
    while (true) {
      boost::asio::read_until(socket, buffer, "\r\n");
      std::istream stream(&buffer);
      std::string line;
      std::getline(stream, line);
      line.pop_back();
      {
        const std::lock_guard<std::mutex> lock(mutex_);
        lines_.push_back(line);
      }
      const std::string command = line.substr(0, 4);
      if (is_data && line != ".") continue;
      if (!refuse_.empty() && command == refuse_) {
        say("550 no");
      } else if (command == "DATA") {
        is_data = true;
        say("354 go on");
      } else if (command == "QUIT") {
        return say("221 bye");
      } else {
        is_data = false;
        say("250 ok");
      }
    }
  }

  const std::string refuse_;
  std::mutex mutex_;
  std::vector<std::string> lines_;
  LocalServer server_{[this](LocalServer::Socket& socket) { Serve(socket); }};
};

/// Answers every request with a status and keeps it.
class HttpServer {
 public:
  using Request = boost::beast::http::request<boost::beast::http::string_body>;

  using Answer = std::function<std::string(const Request&)>;

  explicit HttpServer(unsigned status = 200)
      : HttpServer([](const Request&) { return "{}"; }, status) {}
  /// `answer` says the body, on the server's thread.
  explicit HttpServer(Answer answer, unsigned status = 200)
      : status_(status), answer_(std::move(answer)) {}

  std::string url() const { return "http://127.0.0.1:" + server_.port(); }

  std::vector<Request> requests() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return requests_;
  }
  /// Waits until there are so many, at most half a minute.
  bool WaitFor(std::size_t count) {
    std::unique_lock<std::mutex> lock(mutex_);
    return changed_.wait_for(lock, std::chrono::seconds(30),
                             [&] { return requests_.size() >= count; });
  }

 private:
  void Serve(LocalServer::Socket& socket) {
    namespace http = boost::beast::http;
    boost::beast::flat_buffer buffer;
    Request request;
    http::read(socket, buffer, request);
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      requests_.push_back(request);
    }
    changed_.notify_all();
    http::response<http::string_body> reply(static_cast<http::status>(status_), 11);
    reply.body() = answer_(request);
    reply.keep_alive(false);
    reply.prepare_payload();
    http::write(socket, reply);
  }

  const unsigned status_;
  const Answer answer_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<Request> requests_;
  LocalServer server_{[this](LocalServer::Socket& socket) { Serve(socket); }};
};

}  // namespace coppice::robot::assistance

#endif  // COPPICE_TESTS_ROBOT_APP_ASSISTANCE_LOCAL_SERVER_H_
