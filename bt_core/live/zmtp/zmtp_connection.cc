#include "bt_core/live/zmtp/zmtp_connection.h"

#include <boost/asio/buffer.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/write.hpp>
#include <chrono>
#include <utility>

namespace coppice {
namespace {

namespace asio = boost::asio;
using boost::system::error_code;
using groot2::Parts;
using zmtp::ZmtpPeer;

constexpr auto kHandshakePatience = std::chrono::seconds(5);
constexpr auto kPatience = std::chrono::seconds(10);  // then who is silent is idle
constexpr std::size_t kMaxUnasked = 64;  // pongs for a client that does not read are left out
constexpr std::size_t kMaxTopics = 16;
constexpr std::size_t kMaxTopicBytes = 256;

}  // namespace

ZmtpConnection::ZmtpConnection(WebPort::Socket socket, WebPort& port, Type type,
                               const RobotKeys* keys, LiveClients& clients)
    : PortConnection(port),
      socket_(std::move(socket)),
      type_(type),
      clients_(clients),
      peer_(type, keys, LiveClients::kMaxRequestBytes),
      deadline_(port.context(), kHandshakePatience) {
  error_code error;
  socket_.set_option(asio::ip::tcp::no_delay(true), error);
  socket_.set_option(asio::socket_base::keep_alive(true), error);
}

void ZmtpConnection::Start() {
  deadline_.async_wait([self = shared_from_this()](error_code) {
    if (!self->peer_.is_open()) self->End();
  });
  Go();
}

Claim ZmtpConnection::claim() const {
  if (!peer_.is_open()) return Claim::kStranger;
  const bool is_idle = std::chrono::steady_clock::now() - last_heard() > kPatience;
  if (peer_.may_control()) return is_idle ? Claim::kIdleControls : Claim::kControls;
  return is_idle ? Claim::kIdle : Claim::kWatches;
}

void ZmtpConnection::Read() {
  socket_.async_read_some(asio::buffer(buffer_),
                          [self = shared_from_this()](error_code error, std::size_t size) {
                            error ? self->End() : self->OnRead(size);
                          });
}

void ZmtpConnection::OnRead(std::size_t size) {
  peer_.Receive({buffer_.data(), size});
  Go();
}

// Takes what has arrived, up to a request: the next one has to wait until that is taken.
void ZmtpConnection::Go() {
  Parts message;
  ZmtpPeer::Step step = ZmtpPeer::Step::kMessage;
  while (step == ZmtpPeer::Step::kMessage && !awaits_turn_) {
    step = peer_.Next(message);
    Output output{peer_.TakeOutput()};
    if (unsent_.size() < kMaxUnasked || !peer_.is_open()) Write(std::move(output));
    if (peer_.is_open() && client_ == ClientId()) Enter();
    if (step == ZmtpPeer::Step::kRefused) return EndWhenWritten();
    if (step == ZmtpPeer::Step::kMessage && !Take(std::exchange(message, {}))) return End();
  }
  if (step == ZmtpPeer::Step::kIncomplete) Read();
}

void ZmtpConnection::Enter() {
  Hear();
  deadline_.cancel();
  client_ = type_ == Type::kRouter ? clients_.Enter(shared_from_this(), peer_.may_control())
                                   : clients_.EnterListener(shared_from_this());
}

// What has no empty part before it is from nobody who awaits an answer.
bool ZmtpConnection::Take(Parts message) {
  Hear();
  if (type_ == Type::kPublisher) {
    TakeTopic(message.front());
    return topics_.size() <= kMaxTopics;
  }
  if (message.size() < 2 || !message.front().empty()) return true;
  message.erase(message.begin());
  awaits_turn_ = true;
  clients_.Put(client_, std::move(message));
  return true;
}

// 1 and a topic; 0 and one of those that were said before.
void ZmtpConnection::TakeTopic(const std::string& message) {
  if (message.empty() || message.size() > kMaxTopicBytes) return;
  const std::string topic = message.substr(1);
  if (message[0] == 1) topics_.insert(topic);
  const auto at = topics_.find(topic);
  if (message[0] == 0 && at != topics_.end()) topics_.erase(at);
  clients_.SetTopics(client_, {topics_.begin(), topics_.end()});
}

void ZmtpConnection::ReadOn() {
  asio::post(socket_.get_executor(), [self = shared_from_this()] {
    self->awaits_turn_ = false;
    self->Go();
  });
}

void ZmtpConnection::Post(Parts message, std::size_t bytes) {
  if (type_ == Type::kRouter) message.emplace(message.begin());  // as a REQ awaits it
  asio::post(socket_.get_executor(),
             [self = shared_from_this(), message = std::move(message), bytes] {
               self->Write({self->peer_.Encode(message), bytes});
             });
}

void ZmtpConnection::CutOff() {
  asio::post(socket_.get_executor(), [self = shared_from_this()] { self->End(); });
}

void ZmtpConnection::Write(Output output) {
  if (output.bytes.empty()) return;
  unsent_.push_back(std::move(output));
  if (unsent_.size() == 1) WriteNext();
}

void ZmtpConnection::WriteNext() {
  asio::async_write(socket_, asio::buffer(unsent_.front().bytes),
                    [self = shared_from_this()](error_code error, std::size_t) {
                      error ? self->End() : self->OnWritten();
                    });
}

void ZmtpConnection::OnWritten() {
  if (unsent_.front().room > 0) clients_.GiveRoom(client_, unsent_.front().room);
  unsent_.pop_front();
  if (!unsent_.empty()) {
    WriteNext();
  } else if (is_finishing_) {
    End();
  }
}

void ZmtpConnection::Finish() {
  if (!peer_.is_open()) return End();
  EndWhenWritten();
}

void ZmtpConnection::EndWhenWritten() {
  is_finishing_ = true;
  if (unsent_.empty()) End();
}

void ZmtpConnection::End() {
  deadline_.cancel();
  error_code error;
  socket_.close(error);
  if (client_ != ClientId()) clients_.Leave(client_);
}

}  // namespace coppice
