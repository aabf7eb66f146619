#include "robot_app/monitoring/system/time_server.h"

#include <poll.h>
#include <sys/socket.h>

namespace coppice::robot::monitoring {
namespace {

constexpr std::uint8_t kStratum = 10;

}  // namespace

NtpPacket AnswerOf(const NtpPacket& request, NtpTime received_at, NtpTime now) {
  NtpPacket answer;
  answer.mode = NtpPacket::kServer;
  answer.stratum = kStratum;
  answer.origin = request.transmit;
  answer.receive = received_at;
  answer.transmit = now;
  return answer;
}

TimeServer::TimeServer(const std::string& address, int port, Duration clock_offset)
    : clock_offset_(clock_offset), socket_(ListenUdp(address, port)) {}

void TimeServer::Work(Duration at_most) {
  const Deadline until(at_most);
  pollfd waiting{socket_->fd(), POLLIN, 0};
  do {
    if (poll(&waiting, 1, until.milliseconds()) > 0) Answer();
  } while (!until.has_passed());
}

void TimeServer::Answer() {
  const auto now = [this] { return ToNtp(std::chrono::system_clock::now() + clock_offset_); };
  std::uint8_t data[512];
  sockaddr_storage from{};
  socklen_t size_of_from = sizeof(from);
  const ssize_t size = recvfrom(socket_->fd(), data, sizeof(data), 0,
                                reinterpret_cast<sockaddr*>(&from), &size_of_from);
  const NtpTime received_at = now();
  if (size < 0) return;
  const auto request = NtpPacket::Decode(data, static_cast<std::size_t>(size));
  if (!request || request->mode != NtpPacket::kClient) return;
  const NtpPacket::Bytes answer = AnswerOf(*request, received_at, now()).Encode();
  sendto(socket_->fd(), answer.data(), answer.size(), MSG_NOSIGNAL,
         reinterpret_cast<const sockaddr*>(&from), size_of_from);
}

}  // namespace coppice::robot::monitoring
