// A run that streams over LCM as a site: its messages are passed on to viewers over WebSockets.
#pragma once

#include <memory>
#include <string>

#include "io/live/live_bus.h"
#include "io/serve/site.h"

namespace scree::io {

/// Paths: / (the page), /viewer.js, /viewer.css. Slots: run, mesh, frame, rows, status, events, answer, model, detail
/// (live_messages.h). Of several runs the site shows that of LiveReader; when another run begins, all data are cleared.
/// Without a network, or after the connection fails, it tries again every two seconds.
class LiveSite final : public Site {
 public:
  /// @param run    name of the run to follow; empty: the one that started last
  /// @param token  of pages that may give commands (ControlBridge); empty: none may
  /// @throws std::invalid_argument for a URL that check_live_url refuses for a receiver
  LiveSite(std::string url, std::string run, const std::string& token = {});
  /// On a connection that a run of this program uses (memq).
  LiveSite(std::shared_ptr<LiveBus> bus, std::string run);
  ~LiveSite() override;

  [[nodiscard]] std::optional<Resource> find(std::string_view path) override;
  bool take(std::string_view text) override;
  bool refresh() override;
  [[nodiscard]] std::span<const Slot> slots() const override;

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace scree::io
