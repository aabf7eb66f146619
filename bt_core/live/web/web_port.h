// A port for browsers: listens, and serves its connections on a thread of its own. Included by .cc
// files only; what a connection says is the business of WebVisit's heirs.
//
//   struct Hall {...};                      // what the visits share; lives longer than the port
//   WebPort port_({"127.0.0.1", 0, "coppice_web"}, [this](auto socket, WebPort& port) {
//     return std::make_shared<Visit>(std::move(socket), port, hall_);
//   });
//   ~Loop() { port_.Stop(); }               // before the hall forgets its clients
#ifndef COPPICE_BT_CORE_LIVE_WEB_WEB_PORT_H_
#define COPPICE_BT_CORE_LIVE_WEB_WEB_PORT_H_

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <cstdint>
#include <functional>
#include <memory>
#include <set>
#include <string>
#include <thread>

namespace coppice {

class WebVisit;

struct WebPortOptions {
  std::string address;                ///< as LocalAddress (bt_core/live/web/local_address.h)
  std::uint16_t port = 0;             ///< 0 takes a free one
  const char* thread = "";            ///< its name, at most 15 characters
  std::size_t most_connections = 64;  ///< who comes when there are so many is hung up on
};

class WebPort {
 public:
  using Socket = boost::asio::ip::tcp::socket;
  /// Called on the port's thread for each connection.
  using Welcome = std::function<std::shared_ptr<WebVisit>(Socket socket, WebPort& port)>;

  /// Listens when it returns. Throws std::runtime_error with the reason ("Address already in use")
  /// if the port cannot be had.
  WebPort(const WebPortOptions& options, Welcome welcome);
  ~WebPort() { Stop(); }
  WebPort(const WebPort&) = delete;
  WebPort& operator=(const WebPort&) = delete;

  std::uint16_t port() const { return port_; }
  boost::asio::io_context& context() { return context_; }

  /// Takes leave of all visits (WebVisit::Finish), waits 200 ms at most until they have gone, and
  /// ends the thread. Nothing is served afterwards; a second call does nothing.
  void Stop();

 private:
  friend class WebVisit;

  void Listen(const WebPortOptions& options);
  void Accept();
  void Run(const char* name);
  void Finish();
  void Forget(WebVisit* visit);

  const Welcome welcome_;
  const std::size_t most_connections_;
  std::set<WebVisit*> visits_;  // before the context, in which the last ones end
  bool is_finishing_ = false;
  boost::asio::io_context context_{1};
  boost::asio::ip::tcp::acceptor acceptor_{context_};
  boost::asio::steady_timer pause_{context_};
  std::uint16_t port_ = 0;
  std::thread thread_;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_LIVE_WEB_WEB_PORT_H_
