// What trees say to visitors, from a file of the site (robot_app/config/phrases.yaml): in English
// and German, by the time of day.
#ifndef COPPICE_ROBOT_APP_COMMON_CONFIGURATION_SITE_PHRASES_H_
#define COPPICE_ROBOT_APP_COMMON_CONFIGURATION_SITE_PHRASES_H_

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "bt_core/base/diagnostic.h"
#include "bt_nodes/visitors/phrases.h"

namespace coppice::robot {

/// Minutes since midnight where the robot is.
using MinuteOfDay = std::function<int()>;
int MinuteOfLocalDay();

class SitePhrases : public leaves::Phrases {
 public:
  /// All problems of the file go to `diagnostics`; a phrase that it lacks is one.
  SitePhrases(const std::string& path, Diagnostics& diagnostics,
              MinuteOfDay minute = MinuteOfLocalDay);

  std::string Text(leaves::Phrase phrase, const std::string& language,
                   const std::string& about) override;

 private:
  struct Row {
    int from = 0;                              // [min] since midnight
    std::map<std::string, std::string> texts;  // by language
  };
  const Row& RowOfNow(const std::vector<Row>& rows) const;

  std::vector<std::vector<Row>> phrases_;  // by leaves::Phrase, rows by time
  MinuteOfDay minute_;
};

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_COMMON_CONFIGURATION_SITE_PHRASES_H_
