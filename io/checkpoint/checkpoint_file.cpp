#include "io/checkpoint/checkpoint_file.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

#include "io/checkpoint/archive.h"
#include "io/results/atomic_file.h"
#include "io/results/file_error.h"
#include "io/results/regular_file.h"
#include "io/results/sha256.h"

namespace scree::io {

namespace {

constexpr std::string_view kMagic = "SCREE-CP";
constexpr std::uint32_t kFormat = 10, kByteOrder = 0x01020304;
constexpr std::size_t kDigest = 64, kHead = kMagic.size() + 2 * sizeof(std::uint32_t) + sizeof(std::uint64_t);

struct Head {
  std::uint32_t format = kFormat, byte_order = kByteOrder;
  std::uint64_t length = 0;
  template <class Visitor>
  void visit(Visitor&& see) const {
    see("format", format);
    see("byte order", byte_order);
    see("length", length);
  }
};

std::string read_bytes(const std::filesystem::path& path) {
  require_regular(path);
  std::ifstream in(path, std::ios::binary);
  if (!in) throw FileError(path, std::string("cannot open the checkpoint: ") + std::strerror(errno));
  std::error_code error;
  std::string bytes(std::filesystem::file_size(path, error), '\0');
  if (error) throw FileError(path, "cannot read the checkpoint: " + error.message());
  in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(in.gcount()));
  if (in.bad()) throw FileError(path, std::string("cannot read the checkpoint: ") + std::strerror(errno));
  return bytes;
}

}  // namespace

void write_checkpoint(const std::filesystem::path& path, const RunRecord& run, const ResultsMark& results,
                      const coupling::Checkpoint& checkpoint) {
  const std::uint64_t hash = coupling::state_hash(checkpoint.state);
  const auto pack_body = [&](Packer& pack) {
    run.visit(pack);
    results.visit(pack);
    checkpoint.visit(pack);
    pack("state hash", hash);
  };
  // The length precedes the bytes, which may be many and are never all in memory: a first pass counts them.
  Packer counts([](std::string_view) {});
  pack_body(counts);

  AtomicFile file(path);
  Sha256 digest;
  Packer pack([&](std::string_view piece) {
    digest.add(piece);
    file.write(piece);
  });
  Head head;
  head.length = counts.total() + kDigest;
  for (const char c : kMagic) pack("magic", c);
  head.visit(pack);
  pack_body(pack);
  pack.flush();
  file.write(digest.digest());
  file.commit();
}

StoredCheckpoint read_checkpoint(const std::filesystem::path& path, const std::string& version) {
  const std::string bytes = read_bytes(path);
  const auto refuse = [&](const std::string& why) {
    throw FileError(path, "cannot go on from this checkpoint: " + why);
  };
  if (bytes.size() < kHead) refuse(fmt::format("it is cut short, {} bytes are left", bytes.size()));
  if (!bytes.starts_with(kMagic)) refuse("it does not begin as a checkpoint does");
  Head head;
  coupling::visit_to_write(head, Unpacker(std::string_view(bytes).substr(kMagic.size(), kHead - kMagic.size())));
  if (head.byte_order != kByteOrder) refuse("it is damaged, or of a machine with another byte order");
  if (head.format != kFormat)
    refuse(fmt::format("it is damaged, or of format {}; this program reads format {}", head.format, kFormat));
  if (bytes.size() - kHead != head.length || head.length < kDigest)
    refuse(fmt::format("it has {} bytes in place of {}", bytes.size(), head.length + kHead));
  const std::string_view whole(bytes), said = whole.substr(bytes.size() - kDigest);
  if (sha256(whole.substr(0, bytes.size() - kDigest)) != said) refuse("it is damaged: its checksum is wrong");

  StoredCheckpoint out;
  std::uint64_t hash = 0;
  try {
    Unpacker unpack(whole.substr(kHead, bytes.size() - kHead - kDigest));
    // The version is read first: another version may have other fields after it.
    unpack("run.version", out.run.version);
    if (out.run.version != version)
      refuse(fmt::format("it is of Scree {}, and this is Scree {}", out.run.version, version));
    unpack = Unpacker(whole.substr(kHead, bytes.size() - kHead - kDigest));
    coupling::visit_to_write(out, unpack);
    unpack("state hash", hash);
    unpack.finish();
  } catch (const ArchiveError& e) {
    refuse(std::string("it has other fields than this program writes: it ") + e.what());
  }
  if (hash != coupling::state_hash(out.checkpoint.state)) refuse("it has other fields than this program writes");
  return out;
}

}  // namespace scree::io
