#include "io/report/report.h"

#include "app/commands.h"
#include "app/output.h"

namespace scree::app {

int report(const ReportCommand& command) {
  const std::filesystem::path out = command.out.empty() ? command.run / "report.html" : command.out;
  const io::ReportNote note = io::write_report(command.run, {command.megabytes, SCREE_VERSION}, out);
  say("{}\n", out.string());
  const double megabytes = static_cast<double>(note.bytes) / 1e6;
  if (note.shown < note.stored)
    say("{} of {} frames, {:.1f} MB; --size 0 takes all\n", note.shown, note.stored, megabytes);
  else
    say("{} frames, {:.1f} MB\n", note.shown, megabytes);
  return kDone;
}

}  // namespace scree::app
