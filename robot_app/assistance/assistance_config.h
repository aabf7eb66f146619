// The file supervisors.yaml as values: who looks after the robot, by which channels they are
// reached, how patient the robot is, and where its page is.
//
// Secrets come from the environment only: a password or token in the file must be written as
// "${COPPICE_SOMETHING}". Other texts may be; "${NAME:-otherwise}" gives a default. A channel or
// a way whose variable is not set is left out, with a warning, so one file serves with and without.
#ifndef COPPICE_ROBOT_APP_ASSISTANCE_ASSISTANCE_CONFIG_H_
#define COPPICE_ROBOT_APP_ASSISTANCE_ASSISTANCE_CONFIG_H_

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bt_core/base/diagnostic.h"
#include "robot_app/assistance/help_request.h"
#include "robot_app/common/configuration/environment_text.h"

namespace coppice::robot::assistance {

struct ChannelConfig {
  enum class Kind : std::uint8_t { kConsole, kSmtp, kTelegram, kMatrix, kWebhook };
  std::string name;
  Kind kind = Kind::kConsole;
  std::string url;
  std::string user;     ///< SMTP; may be empty
  std::string secret;   ///< password or token; may be empty for SMTP and webhook
  std::string from;     ///< SMTP: sender's address
  bool answers = true;  ///< Telegram: people may answer by it
};

struct CameraConfig {
  std::string name;
  std::string topic;  ///< sensor_msgs/CompressedImage, JPEG
};

struct PageConfig {
  static constexpr std::size_t kLeastTokenLength = 16;

  std::string address = "127.0.0.1";  ///< as LocalAddress (bt_core/live/web/local_address.h)
  std::uint16_t port = 8090;          ///< 0: no page
  std::string public_url;  ///< how supervisors reach it, without slash at its end; may be empty
  std::string
      operator_token;  ///< empty: only links of messages let in; else at least 16 characters
  std::string viewer_token;
  std::string editor_url;       ///< of the editor's page, for a link to it; may be empty
  double most_linear = 0.4;     ///< m/s, of a person who drives
  double most_angular = 0.8;    ///< rad/s
  double stop_distance = 0.35;  ///< m, kept from the robot's edge to what the laser sees
  std::vector<CameraConfig> cameras;
};

struct AssistanceConfig {
  std::string robot;  ///< its name in messages
  std::vector<ChannelConfig> channels;
  std::vector<HumanSupervisor> supervisors;  ///< in the order in which they are asked
  HelpRules rules;
  std::map<std::string, HelpRules> rules_of_subject;
  PageConfig page;

  const HelpRules& RulesOf(const std::string& subject) const;
};

/// Reads and checks a file. All that is wrong is reported at once; with errors the result is not to
/// be used.
AssistanceConfig LoadAssistanceConfig(const std::string& path, const Environment& environment,
                                      Diagnostics& diagnostics);

}  // namespace coppice::robot::assistance

#endif  // COPPICE_ROBOT_APP_ASSISTANCE_ASSISTANCE_CONFIG_H_
