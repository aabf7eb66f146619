// Lanes of timelines that the user keeps on top, by run and path of the node.
#ifndef COPPICE_EDITOR_TIMELINE_LANE_PINS_H_
#define COPPICE_EDITOR_TIMELINE_LANE_PINS_H_

#include <map>
#include <string>
#include <vector>

namespace coppice::editor {

class LanePins {
 public:
  /// From the top.
  const std::vector<std::string>& Of(const std::string& run) const;
  bool Has(const std::string& run, const std::string& path) const;

  /// Pins a lane below the others, or takes the pin away.
  void Toggle(const std::string& run, const std::string& path);

  const std::map<std::string, std::vector<std::string>>& all() const { return runs_; }

 private:
  std::map<std::string, std::vector<std::string>> runs_;
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_TIMELINE_LANE_PINS_H_
