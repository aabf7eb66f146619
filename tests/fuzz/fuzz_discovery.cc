#include <cstdlib>

#include "bt_core/live/discovery/robot_messages.h"
#include "bt_core/model/utf8.h"
#include "tests/fuzz/fuzz_targets.h"

namespace coppice::fuzz {
namespace {

bool IsPlain(const std::string& text) { return PlainText(text, kLongestNoticeText) == text; }

std::uint16_t IdOf(std::string_view message) {
  if (message.size() < 2) return 0;
  return static_cast<std::uint16_t>(static_cast<unsigned char>(message[0]) << 8U |
                                    static_cast<unsigned char>(message[1]));
}

}  // namespace

int FuzzDiscovery(std::string_view bytes) {
  const std::vector<RobotNotice> robots = ReadAnswer(bytes, IdOf(bytes));
  if (robots.size() > 8) std::abort();
  for (const RobotNotice& robot : robots) {
    if (robot.port == 0 || !IsPlain(robot.host) || !IsPlain(robot.tree)) std::abort();
  }
  const RobotNotice own{"sobi-1667-5", 1667, "sobi", "Patrol", true};
  const std::optional<RobotQuestion> question = ReadQuestion(bytes, own);
  if (!question) return robots.empty() ? 0 : 1;
  const std::string answer = AnswerMessage(own, {192, 168, 1, 7}, *question);
  if (ReadAnswer(answer, question->id).size() != 1 || answer.size() > 1000) std::abort();
  return 2;
}

}  // namespace coppice::fuzz
