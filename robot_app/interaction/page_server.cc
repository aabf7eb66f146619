#include "robot_app/interaction/page_server.h"

#include <pthread.h>

#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <csignal>
#include <stdexcept>
#include <thread>
#include <utility>

#include "bt_core/live/local_address.h"
#include "robot_app/interaction/page_visit.h"

namespace coppice::robot {

namespace asio = boost::asio;
using Tcp = asio::ip::tcp;
using boost::beast::error_code;

constexpr auto kAgainAfter = std::chrono::milliseconds(200);

class PageServer::Loop {
 public:
  Loop(const PageServerOptions& options, PageAccess& access, const Clock& clock)
      : hall_(options, access, clock), acceptor_(context_), pause_(context_) {
    Listen(options);
    Accept();
    thread_ = std::thread([this] { Run(); });
  }
  ~Loop() {
    asio::post(context_, [this] { Finish(); });
    thread_.join();
  }
  Loop(const Loop&) = delete;
  Loop& operator=(const Loop&) = delete;

  std::uint16_t port() const { return port_; }

  bool Receive(PageEvent& event) {
    const std::lock_guard<std::mutex> lock(hall_.mutex);
    if (hall_.events.empty()) return false;
    event = std::move(hall_.events.front());
    hall_.events.pop_front();
    return true;
  }

  void Send(std::uint64_t client, const std::string& key,
            std::shared_ptr<const std::string> message, bool is_binary) {
    asio::post(context_, [this, client, key, message = std::move(message), is_binary] {
      const auto found = hall_.clients.find(client);
      if (found == hall_.clients.end()) return;
      const std::shared_ptr<PageVisit> visit = found->second;
      visit->Send(key, message, is_binary);
    });
  }

 private:
  void Listen(const PageServerOptions& options) {
    try {
      const Tcp::endpoint endpoint(asio::ip::make_address(LocalAddress(options.address)),
                                   options.port);
      acceptor_.open(endpoint.protocol());
      acceptor_.set_option(asio::socket_base::reuse_address(true));
      acceptor_.bind(endpoint);
      acceptor_.listen();
      port_ = acceptor_.local_endpoint().port();
    } catch (const boost::system::system_error& error) {
      throw std::runtime_error("the supervisor page cannot be served on " + options.address + ":" +
                               std::to_string(options.port) + " (" + error.code().message() + ")");
    }
  }

  void Accept() {
    acceptor_.async_accept([this](error_code error, Tcp::socket socket) {
      if (error == asio::error::operation_aborted) return;
      if (!error && hall_.visits.size() < kMostConnections) {
        std::make_shared<PageVisit>(std::move(socket), hall_)->ReadRequest();
      }
      if (!error) return Accept();
      pause_.expires_after(kAgainAfter);  // no descriptors left, for example
      pause_.async_wait([this](error_code cancelled) {
        if (!cancelled) Accept();
      });
    });
  }

  void Run() {
    pthread_setname_np(pthread_self(), "page_server");
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, nullptr);
    while (true) {
      try {
        context_.run();
        return;
      } catch (const std::exception&) {  // no memory: that connection ends
      }
    }
  }

  void Finish() {
    acceptor_.close();
    const std::set<PageVisit*> visits = hall_.visits;
    for (PageVisit* const visit : visits) {
      if (hall_.visits.count(visit) > 0) visit->shared_from_this()->End();
    }
    context_.stop();
  }

  PageHall hall_;  // before the context, in which the last connections end
  asio::io_context context_{1};
  Tcp::acceptor acceptor_;
  asio::steady_timer pause_;
  std::uint16_t port_ = 0;
  std::thread thread_;
};

PageServer::PageServer(const PageServerOptions& options, PageAccess& access, const Clock& clock)
    : loop_(std::make_unique<Loop>(options, access, clock)) {}

PageServer::~PageServer() = default;

std::uint16_t PageServer::port() const { return loop_->port(); }
bool PageServer::Receive(PageEvent& event) { return loop_->Receive(event); }
void PageServer::Send(std::uint64_t client, const std::string& key,
                      std::shared_ptr<const std::string> message, bool is_binary) {
  loop_->Send(client, key, std::move(message), is_binary);
}

}  // namespace coppice::robot
