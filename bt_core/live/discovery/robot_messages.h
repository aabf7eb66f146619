// The messages with which robots are found: multicast DNS (RFC 6762) and its way of naming services
// (RFC 6763), as far as a robot and who looks for it need them. They are read by the resolver of
// the C library, which knows the format and its traps.
//
//   socket.Send(QuestionMessage(id));                             // who looks: where are robots?
//   if (auto asked = ReadQuestion(bytes, robot)) Send(AnswerMessage(robot, address, *asked));
//   for (const RobotNotice& found : ReadAnswer(bytes, id)) ...  // who looks
#ifndef COPPICE_BT_CORE_LIVE_DISCOVERY_ROBOT_MESSAGES_H_
#define COPPICE_BT_CORE_LIVE_DISCOVERY_ROBOT_MESSAGES_H_

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace coppice {

/// The kind of service, for other tools: avahi-browse _coppice._tcp.
inline constexpr const char* kRobotService = "_coppice._tcp.local";

inline constexpr std::size_t kLongestNoticeText = 64;  ///< bytes of a name that is told or read

/// What a robot tells of itself.
struct RobotNotice {
  std::string label;       ///< its name on the network: letters, digits and '-', at most 63
  std::uint16_t port = 0;  ///< of the live view
  std::string host;        ///< name of the computer
  std::string tree;
  bool needs_token = false;
};

/// What somebody asks.
struct RobotQuestion {
  std::uint16_t id = 0;  ///< that the answer has to bear
  std::string bytes;     ///< of it, which the answer repeats; empty if there were several
};

using Ipv4 = std::array<std::uint8_t, 4>;

/// "Where are robots?"
std::string QuestionMessage(std::uint16_t id);

/// Nothing if it is no question that this robot answers, or who asks knows the answer already.
std::optional<RobotQuestion> ReadQuestion(std::string_view message, const RobotNotice& robot);

/// To who asked from a port of his own (RFC 6762, 6.7). `address`: of the robot, in this network.
std::string AnswerMessage(const RobotNotice& robot, const Ipv4& address,
                          const RobotQuestion& question);

/// To all in the network, unasked or asked; or that the robot goes.
std::string AnnouncementMessage(const RobotNotice& robot, const Ipv4& address, bool goes = false);

/// The robots in an answer to the question of that number; any bytes may be handed in. Eight at
/// most. Texts are fit to be shown. An address is not among it: a robot is where its answer comes
/// from.
std::vector<RobotNotice> ReadAnswer(std::string_view message, std::uint16_t id);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_LIVE_DISCOVERY_ROBOT_MESSAGES_H_
