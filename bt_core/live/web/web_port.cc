#include "bt_core/live/web/web_port.h"

#include <pthread.h>

#include <boost/asio/post.hpp>
#include <csignal>
#include <stdexcept>
#include <utility>

#include "bt_core/live/web/local_address.h"
#include "bt_core/live/web/web_visit.h"

namespace coppice {
namespace {

namespace asio = boost::asio;
using boost::system::error_code;

constexpr auto kPause = std::chrono::milliseconds(200);

}  // namespace

WebPort::WebPort(const WebPortOptions& options, Welcome welcome)
    : welcome_(std::move(welcome)), most_connections_(options.most_connections) {
  Listen(options);
  Accept();
  thread_ = std::thread([this, name = options.thread] { Run(name); });
}

void WebPort::Stop() {
  if (!thread_.joinable()) return;
  asio::post(context_, [this] { Finish(); });
  thread_.join();
  is_finishing_ = false;
}

void WebPort::Listen(const WebPortOptions& options) {
  try {
    const asio::ip::tcp::endpoint endpoint(asio::ip::make_address(LocalAddress(options.address)),
                                           options.port);
    acceptor_.open(endpoint.protocol());
    acceptor_.set_option(asio::socket_base::reuse_address(true));
    acceptor_.bind(endpoint);
    acceptor_.listen();
    port_ = acceptor_.local_endpoint().port();
  } catch (const boost::system::system_error& error) {
    throw std::runtime_error(error.code().message());
  }
}

void WebPort::Accept() {
  acceptor_.async_accept([this](error_code error, Socket socket) {
    if (error == asio::error::operation_aborted) return;
    if (!error && visits_.size() < most_connections_) {
      welcome_(std::move(socket), *this)->ReadRequest();
    }
    if (!error) return Accept();
    // No descriptors left, for example: not at once again.
    pause_.expires_after(kPause);
    pause_.async_wait([this](error_code cancelled) {
      if (!cancelled) Accept();
    });
  });
}

void WebPort::Run(const char* name) {
  pthread_setname_np(pthread_self(), name);
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

void WebPort::Finish() {
  acceptor_.close();
  const std::set<WebVisit*> visits = visits_;
  for (WebVisit* const visit : visits) {
    if (visits_.count(visit) > 0) visit->Finish();
  }
  if (visits_.empty()) return context_.stop();
  pause_.expires_after(kPause);
  pause_.async_wait([this](error_code) { context_.stop(); });
  is_finishing_ = true;
}

void WebPort::Forget(WebVisit* visit) {
  visits_.erase(visit);
  if (visits_.empty() && is_finishing_) pause_.cancel();
}

}  // namespace coppice
