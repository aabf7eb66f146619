#include "robot_app/storage/server/mongo_server.h"

#include <mongoc/mongoc.h>

#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

// A bson_t is aligned more than usual, which template arguments forget; here they are pointers.
#pragma GCC diagnostic ignored "-Wignored-attributes"

namespace coppice::robot::storage {
namespace {

using Answer = StoreResult::Answer;

constexpr int kDuplicateKey = 11000;

template <class Thing, void (*Free)(Thing*)>
struct Deleter {
  void operator()(Thing* thing) const { Free(thing); }
};
template <class Thing, void (*Free)(Thing*)>
using Owned = std::unique_ptr<Thing, Deleter<Thing, Free>>;
using Bson = Owned<bson_t, bson_destroy>;
using Uri = Owned<mongoc_uri_t, mongoc_uri_destroy>;
using Client = Owned<mongoc_client_t, mongoc_client_destroy>;
using Collection = Owned<mongoc_collection_t, mongoc_collection_destroy>;

// libmongoc wants to be initialised once, and cleans up at the end of the program.
void Initialise() {
  static const bool done = (mongoc_init(), true);
  (void)done;
}

void AddText(bson_t* bson, const char* key, const std::string& text) {
  bson_append_utf8(bson, key, -1, text.data(), static_cast<int>(text.size()));
}

void AddMoment(bson_t* bson, const char* key, std::int64_t nanoseconds) {
  bson_append_date_time(bson, key, -1, nanoseconds / 1'000'000);
}

// {robot, spool, number}: the key of a message.
void AddKey(bson_t* bson, const Batch& batch, const Document& document) {
  bson_t key;
  bson_append_document_begin(bson, "_id", -1, &key);
  AddText(&key, "robot", batch.robot);
  AddText(&key, "spool", batch.spool);
  bson_append_int64(&key, "number", -1, document.number);
  bson_append_document_end(bson, &key);
}

Expected<Bson> ToBson(const Batch& batch, const Document& document) {
  bson_error_t error;
  const Bson content(bson_new_from_json(reinterpret_cast<const std::uint8_t*>(document.json.data()),
                                        static_cast<ssize_t>(document.json.size()), &error));
  if (!content) return Problem{error.message};
  const MessageType& type = *document.type;
  Bson bson(bson_new());
  AddKey(bson.get(), batch, document);
  AddMoment(bson.get(), "time", document.received);
  bson_append_int64(bson.get(), "stamp", -1, document.stamp);
  AddText(bson.get(), "topic", document.topic);
  AddText(bson.get(), "type", type.name);
  AddText(bson.get(), "md5", type.md5);
  bson_append_document(bson.get(), "document", -1, content.get());
  return bson;
}

std::set<const MessageType*> TypesOf(const Batch& batch) {
  std::set<const MessageType*> types;
  for (const Document& document : batch.documents) types.insert(document.type.get());
  return types;
}

Bson TypeToBson(const MessageType& type) {
  Bson bson(bson_new());
  AddText(bson.get(), "_id", type.name + " " + type.md5);
  AddText(bson.get(), "name", type.name);
  AddText(bson.get(), "md5", type.md5);
  AddText(bson.get(), "definition", type.definition);
  return bson;
}

// The only errors are keys that are there already: from an earlier time.
bool AreDuplicates(const bson_t* reply) {
  bson_iter_t errors, error;
  if (!bson_iter_init_find(&errors, reply, "writeErrors")) return false;
  if (bson_iter_init_find(&error, reply, "writeConcernErrors")) return false;
  if (!BSON_ITER_HOLDS_ARRAY(&errors) || !bson_iter_recurse(&errors, &error)) return false;
  bool are = true;
  while (bson_iter_next(&error)) {
    bson_iter_t code;
    are = are && bson_iter_recurse(&error, &code) && bson_iter_find(&code, "code") &&
          bson_iter_as_int64(&code) == kDuplicateKey;
  }
  return are;
}

StoreResult Insert(mongoc_client_t* client, const std::string& database, const char* name,
                   const std::vector<Bson>& documents) {
  if (documents.empty()) return {};
  std::vector<const bson_t*> list;
  for (const Bson& document : documents) list.push_back(document.get());
  const Collection collection(mongoc_client_get_collection(client, database.c_str(), name));
  const Bson options(BCON_NEW("ordered", BCON_BOOL(false)));
  bson_t reply;
  bson_error_t error;
  const bool is_done = mongoc_collection_insert_many(collection.get(), list.data(), list.size(),
                                                     options.get(), &reply, &error);
  const bool is_stored = is_done || AreDuplicates(&reply);
  bson_destroy(&reply);
  return is_stored ? StoreResult() : StoreResult{Answer::kAway, error.message};
}

// Counts only grow; a late one does not make them smaller.
StoreResult StoreLosses(mongoc_client_t* client, const std::string& database, const Batch& batch) {
  const Collection collection(mongoc_client_get_collection(client, database.c_str(), "losses"));
  const Bson options(BCON_NEW("upsert", BCON_BOOL(true)));
  for (const Loss& loss : batch.losses) {
    const Bson which(
        BCON_NEW("robot", BCON_UTF8(batch.robot.c_str()), "spool", BCON_UTF8(batch.spool.c_str()),
                 "topic", BCON_UTF8(loss.topic.c_str()), "reason", BCON_UTF8(loss.reason.c_str())));
    const Bson change(BCON_NEW("$max", "{", "count", BCON_INT64(loss.count), "last",
                               BCON_DATE_TIME(loss.last / 1'000'000), "}", "$min", "{", "first",
                               BCON_DATE_TIME(loss.first / 1'000'000), "}"));
    bson_error_t error;
    if (!mongoc_collection_update_one(collection.get(), which.get(), change.get(), options.get(),
                                      nullptr, &error)) {
      return {Answer::kAway, error.message};
    }
  }
  return {};
}

}  // namespace

struct MongoServer::Session {
  std::string database;
  Client client;
};

std::string MongoUri(const ServerConfig& config) {
  const std::string host =
      config.host.find(':') == std::string::npos ? config.host : "[" + config.host + "]";
  return "mongodb://" + host + ":" + std::to_string(config.port) +
         "/?appName=coppice-store&connectTimeoutMS=5000&serverSelectionTimeoutMS=5000"
         "&socketTimeoutMS=30000&w=majority&journal=true&tls=" +
         (config.is_encrypted ? "true" : "false");
}

Expected<std::string> MongoDocument(const Batch& batch, const Document& document) {
  const Expected<Bson> bson = ToBson(batch, document);
  if (!bson) return Problem{bson.problem()};
  char* const text = bson_as_canonical_extended_json(bson->get(), nullptr);
  std::string json = text;
  bson_free(text);
  return json;
}

MongoServer::MongoServer(const ServerConfig& config) {
  Initialise();
  bson_error_t error;
  const Uri uri(mongoc_uri_new_with_error(MongoUri(config).c_str(), &error));
  if (!uri) throw std::runtime_error(error.message);
  if (!config.user.empty()) mongoc_uri_set_username(uri.get(), config.user.c_str());
  if (!config.password.empty()) mongoc_uri_set_password(uri.get(), config.password.c_str());
  if (config.is_encrypted && !config.authority.empty()) {
    mongoc_uri_set_option_as_utf8(uri.get(), MONGOC_URI_TLSCAFILE, config.authority.c_str());
  }
  session_ = std::make_unique<Session>(
      Session{config.database, Client(mongoc_client_new_from_uri(uri.get()))});
  mongoc_client_set_error_api(session_->client.get(), MONGOC_ERROR_API_VERSION_2);
}

MongoServer::~MongoServer() = default;

// MongoDB has no transaction without a replica set, and none is needed: what has arrived of a batch
// is found there when it comes again.
StoreResult MongoServer::Store(const Batch& batch) {
  std::vector<Bson> types, documents;
  for (const MessageType* type : TypesOf(batch)) types.push_back(TypeToBson(*type));
  for (const Document& document : batch.documents) {
    Expected<Bson> bson = ToBson(batch, document);
    if (!bson) return {Answer::kRefused, bson.problem()};
    documents.push_back(*std::move(bson));
  }
  mongoc_client_t* const client = session_->client.get();
  const std::string& database = session_->database;
  const StoreResult described = Insert(client, database, "types", types);
  if (described.answer != Answer::kStored) return described;
  const StoreResult stored = Insert(client, database, "messages", documents);
  if (stored.answer != Answer::kStored) return stored;
  return StoreLosses(client, database, batch);
}

}  // namespace coppice::robot::storage
