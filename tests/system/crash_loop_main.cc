// crash_loop: stands in the place of a program of the robot (build/bin/NAME, NAME as it was called)
// and starts it, but kills it 1.5 to 3 s after each start, as long as it finds damage: a program
// that stumbles over bad state that outlives it. The damage is the parameter /crash_loop/NAME of
// the ROS parameter server, of which a new ROS master knows nothing; or the file NAME.damage beside
// it, which nobody but a person takes away.
#include <ros/ros.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <string>

#include "tests/support/folders.h"

namespace {

volatile std::sig_atomic_t g_stop = 0;

bool HasParameter(const std::string& parameter) {
  XmlRpc::XmlRpcValue request, response, payload;
  request[0] = "/crash_loop";
  request[1] = parameter;
  return ros::master::execute("hasParam", request, response, payload, false) &&
         static_cast<bool>(payload);
}

pid_t Start(const std::string& program, char** argv) {
  const pid_t parent = getpid();
  const pid_t pid = fork();
  if (pid != 0) return pid;
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(1);
  execv(program.c_str(), argv);
  _exit(127);
}

// SIGTERM is passed on; the end of the child is ours.
int WaitFor(pid_t pid, double seconds) {
  int status = 0;
  bool told = false;
  for (double waited = 0; waitpid(pid, &status, WNOHANG) == 0; waited += 0.02) {
    if (g_stop != 0 && !told) kill(pid, SIGTERM);
    told = told || g_stop != 0;
    if (waited > seconds && !told) kill(pid, SIGABRT);
    usleep(20000);
  }
  return status;
}

}  // namespace

int main(int, char** argv) {
  const std::string path = argv[0];
  const std::string name = path.substr(path.rfind('/') + 1);
  const std::string program = coppice::BinaryFolder() + "/bin/" + name;
  int no_arguments = 0;
  ros::init(no_arguments, nullptr, "crash_loop",
            ros::init_options::AnonymousName | ros::init_options::NoSigintHandler);
  std::signal(SIGTERM, [](int) { g_stop = 1; });
  std::signal(SIGINT, [](int) { g_stop = 1; });
  std::mt19937 random(static_cast<unsigned>(getpid()));
  std::string parameter = "/crash_loop/" + name;
  std::replace(parameter.begin(), parameter.end(), '-', '_');  // as names in ROS are
  const bool damaged = std::filesystem::exists(path + ".damage") || HasParameter(parameter);
  const double lifetime = damaged ? std::uniform_real_distribution<double>(1.5, 3)(random) : 1e9;
  const int status = WaitFor(Start(program, argv), lifetime);
  if (WIFEXITED(status)) return WEXITSTATUS(status);
  std::signal(WTERMSIG(status), SIG_DFL);
  raise(WTERMSIG(status));
  return 1;
}
