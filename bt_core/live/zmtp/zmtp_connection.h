// One connection of a client of ZeroMQ. Included by .cc files only; the port's thread only, but for
// what LiveConnection promises.
#ifndef COPPICE_BT_CORE_LIVE_ZMTP_ZMTP_CONNECTION_H_
#define COPPICE_BT_CORE_LIVE_ZMTP_ZMTP_CONNECTION_H_

#include <array>
#include <cstddef>
#include <deque>
#include <memory>
#include <set>
#include <string>

#include "bt_core/live/server/live_clients.h"
#include "bt_core/live/web/web_port.h"
#include "bt_core/live/zmtp/zmtp_peer.h"

namespace coppice {

class ZmtpConnection final : public PortConnection,
                             public LiveConnection,
                             public std::enable_shared_from_this<ZmtpConnection> {
 public:
  using Type = zmtp::ZmtpPeer::Type;

  /// `keys` (null: there is no token) and `clients` must live longer.
  ZmtpConnection(WebPort::Socket socket, WebPort& port, Type type, const RobotKeys* keys,
                 LiveClients& clients);

  void Start() override;
  void Finish() override;
  void HangUp() override { End(); }
  Claim claim() const override;

  void Post(groot2::Parts message, std::size_t bytes) override;
  void ReadOn() override;
  void CutOff() override;

 private:
  struct Output {
    std::string bytes;
    std::size_t room = 0;  // that was taken for it
  };

  void Read();
  void OnRead(std::size_t size);
  void Go();
  void Enter();
  bool Take(groot2::Parts message);
  void TakeTopic(const std::string& message);
  void Write(Output output);
  void WriteNext();
  void OnWritten();
  void EndWhenWritten();
  void End();

  WebPort::Socket socket_;
  const Type type_;
  LiveClients& clients_;
  zmtp::ZmtpPeer peer_;
  boost::asio::steady_timer deadline_;  // of the handshake
  ClientId client_{};
  std::array<char, 16 << 10> buffer_;
  std::deque<Output> unsent_;
  std::multiset<std::string> topics_;
  bool awaits_turn_ = false;  // a request was not taken yet
  bool is_finishing_ = false;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_LIVE_ZMTP_ZMTP_CONNECTION_H_
