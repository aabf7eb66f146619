// Ports of the robot: listens, and serves the connections of all its ports on one thread. Included
// by .cc files only; what a connection says is the business of PortConnection's subclasses.
//
//   struct SharedState {...};               // of the connections; lives longer than the port
//   WebPort port_({"127.0.0.1", 0, "coppice_web"}, [this](auto socket, WebPort& port) {
//     return std::make_shared<Connection>(std::move(socket), port, shared_);
//   });
//   ~Loop() { port_.Stop(); }               // before the shared state ends
//
// Strangers can fill a port with connections, and so can somebody who may only watch. When it is
// full, who has the least claim to stay gives way to who comes, whom nobody knows yet; of
// strangers, one of the address that has most of them; of equals, who was silent longest.
#ifndef COPPICE_BT_CORE_LIVE_WEB_WEB_PORT_H_
#define COPPICE_BT_CORE_LIVE_WEB_WEB_PORT_H_

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <set>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace coppice {

class PortConnection;

/// What speaks for keeping a connection when its port is full; who has the least goes first. Those
/// who watch take no place from those who control, who have half of the port for themselves.
enum class Claim : std::uint8_t {
  kStranger,      ///< it has not shown who it is
  kIdle,          ///< it may only watch, and was silent for a while
  kWatches,       ///< gives way only while those who watch have more than half of the port
  kIdleControls,  ///< it may control, and was silent; only while those have more than half
  kControls,      ///< never gives way
};

struct WebPortOptions {
  std::string address;                 ///< as LocalAddress (bt_core/live/web/local_address.h)
  std::uint16_t port = 0;              ///< 0 takes a free one
  const char* thread = "";             ///< its name, at most 15 characters
  std::size_t most_connections = 256;  ///< who comes when none of so many gives way is hung up on
};

class WebPort {
 public:
  using Socket = boost::asio::ip::tcp::socket;
  /// Called on the port's thread for each connection.
  using Handler = std::function<std::shared_ptr<PortConnection>(Socket socket, WebPort& port)>;

  /// Listens when it returns. Throws std::runtime_error with the reason ("Address already in use")
  /// if the port cannot be had.
  WebPort(const WebPortOptions& options, Handler handler);
  ~WebPort() { Stop(); }
  WebPort(const WebPort&) = delete;
  WebPort& operator=(const WebPort&) = delete;

  /// Listens on one more port, whose number it returns; throws as the constructor does.
  std::uint16_t AlsoListen(const WebPortOptions& options, Handler handler);

  std::uint16_t port() const { return port_; }
  boost::asio::io_context& context() { return context_; }

  /// Takes leave of all connections (PortConnection::Finish), waits 200 ms at most until they have
  /// gone, and ends the thread. Nothing is served afterwards; a second call does nothing.
  void Stop();

 private:
  friend class PortConnection;

  // One of the ports, with its connections.
  struct Door {
    Door(boost::asio::io_context& context, std::size_t most, Handler who)
        : most_connections(most), handler(std::move(who)), acceptor(context), pause(context) {}
    const std::size_t most_connections;
    const Handler handler;
    std::set<PortConnection*> connections;
    boost::asio::ip::tcp::acceptor acceptor;
    boost::asio::steady_timer pause;
  };

  static void Bind(Door& door, const WebPortOptions& options);
  void Accept(Door& door);
  void Admit(Door& door, Socket socket);
  static bool MakeRoom(Door& door);
  void Run(const char* name);
  void Finish();
  bool IsEmpty() const;
  void Forget(PortConnection* connection);

  bool is_finishing_ = false;
  // Before the context, in which the last connections end.
  std::vector<std::shared_ptr<Door>> doors_;
  boost::asio::io_context context_{1};
  boost::asio::steady_timer end_{context_};
  std::uint16_t port_ = 0;
  std::thread thread_;
};

/// One connection of a port. Its thread only.
class PortConnection {
 public:
  explicit PortConnection(WebPort& port) : port_(port) {}
  virtual ~PortConnection() { port_.Forget(this); }
  PortConnection(const PortConnection&) = delete;
  PortConnection& operator=(const PortConnection&) = delete;

  /// Begins to listen to it.
  virtual void Start() = 0;
  /// Ends when everything is sent.
  virtual void Finish() = 0;
  /// Ends now.
  virtual void HangUp() = 0;
  virtual Claim claim() const = 0;

  /// From where it came; empty if it has gone already.
  const std::string& address() const { return address_; }

  using Moment = std::chrono::steady_clock::time_point;
  /// When it last said something that made sense.
  Moment last_heard() const { return last_heard_; }

 protected:
  void Hear() { last_heard_ = std::chrono::steady_clock::now(); }

 private:
  friend class WebPort;

  WebPort& port_;
  std::string address_;
  Moment last_heard_ = std::chrono::steady_clock::now();
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_LIVE_WEB_WEB_PORT_H_
