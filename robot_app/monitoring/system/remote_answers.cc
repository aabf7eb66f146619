#include "robot_app/monitoring/system/remote_answers.h"

namespace coppice::robot::monitoring {

RemoteAnswers AskComputers(const RemoteQuestions& questions) {
  return {QueryClocks(questions.clocks, questions.deadline),
          TryToReach(questions.hosts, questions.deadline)};
}

}  // namespace coppice::robot::monitoring
