// Tables of a report: the same one as Markdown and as HTML.
#ifndef COPPICE_ROBOT_APP_DEPLOYMENT_REPORT_TABLE_H_
#define COPPICE_ROBOT_APP_DEPLOYMENT_REPORT_TABLE_H_

#include <string>
#include <vector>

namespace coppice::robot::deployment {

struct Table {
  std::string title;
  std::vector<std::string> head;
  std::vector<std::vector<std::string>> rows;
  std::string note;  ///< below it; may be empty
};

std::string ToMarkdown(const Table& table);
std::string ToHtml(const Table& table);

/// "%.1f" and the like.
std::string Printed(const char* format, double number);

}  // namespace coppice::robot::deployment

#endif  // COPPICE_ROBOT_APP_DEPLOYMENT_REPORT_TABLE_H_
