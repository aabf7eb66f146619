#include "robot_app/storage/server/postgres_reader.h"

#include <pthread.h>
#include <sys/socket.h>

#include <future>
#include <map>
#include <pqxx/pqxx>
#include <stdexcept>

#include "robot_app/storage/server/postgres_server.h"

namespace coppice::robot::storage {
namespace {

constexpr const char* kFetch = "FETCH 1000 FROM stored";

std::string Cursor(const pqxx::transaction_base& work, const StoredQuery& query) {
  std::string text =
      "DECLARE stored CURSOR FOR SELECT to_char(time AT TIME ZONE 'UTC', "
      "'YYYY-MM-DD HH24:MI:SS.US'), stamp, topic, m.type, m.md5, t.definition, document "
      "FROM coppice.messages m JOIN coppice.types t ON t.name = m.type AND t.md5 = m.md5 WHERE true";
  if (!query.robot.empty()) text += " AND robot = " + work.quote(query.robot);
  if (!query.from.empty()) text += " AND time >= " + work.quote(query.from) + "::timestamptz";
  if (!query.to.empty()) text += " AND time < " + work.quote(query.to) + "::timestamptz";
  std::string topics;
  for (const std::string& topic : query.topics) {
    topics += (topics.empty() ? "" : ", ") + work.quote(topic);
  }
  if (!topics.empty()) text += " AND topic IN (" + topics + ")";
  return text + " ORDER BY time, robot, spool, number";
}

class Reader {
 public:
  StoredMessage Read(const pqxx::row& row) {
    StoredMessage message;
    message.time = row[0].as<std::string>();
    message.stamp = row[1].as<std::int64_t>();
    message.topic = row[2].as<std::string>();
    std::shared_ptr<const MessageType>& type = types_[{row[3].c_str(), row[4].c_str()}];
    if (!type) {
      type = std::make_shared<const MessageType>(
          MessageType{row[3].c_str(), row[4].c_str(), row[5].c_str()});
    }
    message.type = type;
    message.json = row[6].as<std::string>();
    return message;
  }

 private:
  std::map<std::pair<std::string, std::string>, std::shared_ptr<const MessageType>> types_;
};

// libpq waits without end for an answer; hanging up ends that.
pqxx::result Ask(pqxx::transaction_base& work, const std::string& question, Duration patience) {
  const int socket = work.conn().sock();
  std::promise<void> is_over;
  auto is_late = std::async(std::launch::async, [socket, patience, end = is_over.get_future()] {
    pthread_setname_np(pthread_self(), "patience");
    if (end.wait_for(patience) == std::future_status::ready) return false;
    shutdown(socket, SHUT_RDWR);
    return true;
  });
  try {
    pqxx::result answer = work.exec(question);
    is_over.set_value();
    return answer;
  } catch (const std::exception&) {
    is_over.set_value();
    if (!is_late.get()) throw;
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(patience).count();
    throw std::runtime_error("the server has not answered for " + std::to_string(seconds) + " s");
  }
}

}  // namespace

Outcome ReadStored(const ServerConfig& server, const StoredQuery& query,
                   const std::function<bool(const StoredMessage& message)>& use) {
  try {
    pqxx::connection connection(ConnectionText(server));
    pqxx::nontransaction work(connection);  // pqxx::work would wait for an answer to its end, too
    const auto ask = [&](const std::string& question) {
      return Ask(work, question, query.patience);
    };
    ask("BEGIN");
    ask(Cursor(work, query));
    Reader reader;
    while (true) {
      const pqxx::result rows = ask(kFetch);
      if (rows.empty()) return {};
      for (const pqxx::row& row : rows) {
        if (!use(reader.Read(row))) return {};
      }
    }
  } catch (const std::exception& error) {
    const std::string text = error.what();
    return Problem{text.substr(0, text.find('\n'))};
  }
}

}  // namespace coppice::robot::storage
