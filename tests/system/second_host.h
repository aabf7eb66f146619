// A second computer beside the robot's own: a network namespace with a network of its own to this
// one, that can be cut. Programs run there as they would on another computer, but for the disk.
#ifndef COPPICE_TESTS_SYSTEM_SECOND_HOST_H_
#define COPPICE_TESTS_SYSTEM_SECOND_HOST_H_

#include <string>
#include <vector>

namespace coppice::robot {

class SecondHost {
 public:
  /// Makes it. Look at error() whether that was possible.
  SecondHost();
  ~SecondHost();
  SecondHost(const SecondHost&) = delete;
  SecondHost& operator=(const SecondHost&) = delete;

  /// Why there is none, for people; empty if there is one.
  const std::string& error() const { return error_; }
  std::string own_address() const { return network_ + ".1"; }  ///< of this computer for it
  std::string address() const { return network_ + ".2"; }      ///< of it for this computer
  /// The words before a command that is to run there.
  std::vector<std::string> prefix() const { return {"/sbin/ip", "netns", "exec", name_}; }
  /// The same over the network: without connection it ends with status 255, as ssh does.
  std::vector<std::string> transport() const;

  /// Pulls the plug, or puts it in again.
  void Cut();
  void Join();

 private:
  bool Run(const std::string& command);
  std::string far() const { return "cf" + name_.substr(7); }  // its end of the network

  std::string name_;
  std::string network_;
  std::string error_;
};

}  // namespace coppice::robot

#endif  // COPPICE_TESTS_SYSTEM_SECOND_HOST_H_
