#include "robot_app/monitoring/system/sntp.h"

#include <poll.h>
#include <sys/socket.h>

#include <cerrno>
#include <cstring>

#include "robot_app/monitoring/system/sockets.h"

namespace coppice::robot::monitoring {
namespace {

constexpr std::uint64_t kSecondsFrom1900To1970 = 2208988800;
constexpr std::int64_t kNanoseconds = 1000000000;
constexpr std::uint8_t kVersion = 4;
constexpr std::size_t kOrigin = 24, kReceive = 32, kTransmit = 40;  // offsets in the packet

void Put(NtpPacket::Bytes& bytes, std::size_t offset, NtpTime time) {
  for (int i = 0; i < 8; ++i) bytes[offset + i] = static_cast<std::uint8_t>(time >> (56 - 8 * i));
}

NtpTime Get(const std::uint8_t* data) {
  NtpTime time = 0;
  for (int i = 0; i < 8; ++i) time = time << 8 | data[i];
  return time;
}

// One question under way.
struct Question {
  Socket socket;
  NtpTime sent_at = 0;
  bool is_done = false;
};

void Ask(const ClockServer& server, Question& question, Expected<ClockReading>& reading) {
  Expected<Socket> socket = Connect(server.address, server.port, SOCK_DGRAM);
  question.is_done = !socket;
  if (!socket) {
    reading = Problem{socket.problem()};
    return;
  }
  question.socket = *std::move(socket);
  const int enabled = 1;  // the kernel notes when a reply came, however late we look
  setsockopt(question.socket.fd(), SOL_SOCKET, SO_TIMESTAMPNS, &enabled, sizeof(enabled));
  NtpPacket request;
  request.transmit = question.sent_at = ToNtp(std::chrono::system_clock::now());
  const NtpPacket::Bytes bytes = request.Encode();
  if (send(question.socket.fd(), bytes.data(), bytes.size(), MSG_NOSIGNAL) >= 0) return;
  reading = Problem{std::strerror(errno)};
  question.is_done = true;
}

// When the message arrived, as the kernel says, else now.
NtpTime ArrivalOf(msghdr& message) {
  for (cmsghdr* part = CMSG_FIRSTHDR(&message); part; part = CMSG_NXTHDR(&message, part)) {
    if (part->cmsg_level != SOL_SOCKET || part->cmsg_type != SCM_TIMESTAMPNS) continue;
    timespec time{};
    std::memcpy(&time, CMSG_DATA(part), sizeof(time));
    return ToNtp(WallTime(std::chrono::seconds(time.tv_sec) + Duration(time.tv_nsec)));
  }
  return ToNtp(std::chrono::system_clock::now());
}

void Receive(Question& question, Expected<ClockReading>& reading) {
  std::uint8_t data[512];
  alignas(cmsghdr) char control[CMSG_SPACE(sizeof(timespec))];
  iovec buffer{data, sizeof(data)};
  msghdr message{};
  message.msg_iov = &buffer;
  message.msg_iovlen = 1;
  message.msg_control = control;
  message.msg_controllen = sizeof(control);
  const ssize_t size = recvmsg(question.socket.fd(), &message, MSG_DONTWAIT);
  if (size < 0) {
    if (errno == EAGAIN || errno == EINTR) return;
    reading = Problem{std::strerror(errno)};
    question.is_done = true;
    return;
  }
  const auto reply = NtpPacket::Decode(data, static_cast<std::size_t>(size));
  // An answer to an older question, or somebody's rubbish: the right one may still come.
  if (!reply || reply->mode != NtpPacket::kServer || reply->origin != question.sent_at) return;
  reading = ReadReply(*reply, question.sent_at, ArrivalOf(message));
  question.is_done = true;
}

}  // namespace

NtpTime ToNtp(WallTime time) {
  const std::int64_t nanoseconds = time.time_since_epoch().count();
  const auto seconds = static_cast<std::uint64_t>(nanoseconds / kNanoseconds);
  const auto rest = static_cast<std::uint64_t>(nanoseconds % kNanoseconds);
  return (seconds + kSecondsFrom1900To1970) << 32 | (rest << 32) / kNanoseconds;
}

double NtpSeconds(NtpTime later, NtpTime earlier) {
  return static_cast<double>(static_cast<std::int64_t>(later - earlier)) / 4294967296.0;
}

NtpPacket::Bytes NtpPacket::Encode() const {
  Bytes bytes{};
  bytes[0] = static_cast<std::uint8_t>(leap << 6 | kVersion << 3 | mode);
  bytes[1] = stratum;
  Put(bytes, kOrigin, origin);
  Put(bytes, kReceive, receive);
  Put(bytes, kTransmit, transmit);
  return bytes;
}

std::optional<NtpPacket> NtpPacket::Decode(const std::uint8_t* data, std::size_t size) {
  if (size < kSize) return std::nullopt;
  NtpPacket packet;
  packet.leap = data[0] >> 6;
  packet.mode = static_cast<Mode>(data[0] & 7);
  packet.stratum = data[1];
  packet.origin = Get(data + kOrigin);
  packet.receive = Get(data + kReceive);
  packet.transmit = Get(data + kTransmit);
  return packet;
}

Expected<ClockReading> ReadReply(const NtpPacket& reply, NtpTime t1, NtpTime t4) {
  if (reply.stratum == 0) return Problem{"the time server refuses to answer"};
  if (reply.leap == NtpPacket::kNotSynchronized || reply.transmit == 0) {
    return Problem{"the time server is not synchronized itself"};
  }
  return ClockReading{(NtpSeconds(reply.receive, t1) + NtpSeconds(reply.transmit, t4)) / 2,
                      NtpSeconds(t4, t1) - NtpSeconds(reply.transmit, reply.receive)};
}

std::vector<Expected<ClockReading>> QueryClocks(const std::vector<ClockServer>& servers,
                                                Duration deadline) {
  std::vector<Question> questions(servers.size());
  std::vector<Expected<ClockReading>> readings(servers.size(), Problem{"no answer"});
  for (std::size_t i = 0; i < servers.size(); ++i) Ask(servers[i], questions[i], readings[i]);
  const Deadline until(deadline);
  std::vector<pollfd> waiting;
  do {
    waiting.clear();
    for (const Question& question : questions) {
      if (!question.is_done) waiting.push_back({question.socket.fd(), POLLIN, 0});
    }
    if (waiting.empty()) break;
    if (poll(waiting.data(), waiting.size(), until.milliseconds()) <= 0) continue;
    for (std::size_t i = 0; i < questions.size(); ++i) {
      if (!questions[i].is_done) Receive(questions[i], readings[i]);
    }
  } while (!until.has_passed());
  return readings;
}

}  // namespace coppice::robot::monitoring
