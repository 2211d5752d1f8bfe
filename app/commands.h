// The commands of `scree`, one function each. They print for people and return the exit code.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/studies/tier.h"

namespace scree::app {

/// Exit codes (io-and-live): 0 done, 2 usage, 3 bad case, 4 did not converge, 5 files, 130 interrupted.
enum Exit : int { kDone = 0, kFailed = 1, kUsage = 2, kBadCase = 3, kNotConverged = 4, kFiles = 5, kInterrupted = 130 };

struct RunOptions {
  std::filesystem::path case_file;
  std::filesystem::path out;  // empty: runs/<name of the case>
  std::string name;           // of the run in the stream; empty: name of the run folder
  bool overwrite = false, quiet = false;
  bool audit = false;                // check every step
  std::optional<std::string> live;   // URL of the stream; an empty text keeps that of the case
  bool control = false;              // accept commands over the stream
  int threads = 0;                   // 0: as the case states, else as many as the machine has
  std::optional<double> until;       // [s]
  std::vector<std::string> set;      // key=value
  std::filesystem::path start_from;  // run folder whose end this run continues; empty: from the start
  std::string command_line;
};
int run(const RunOptions& options);
struct ResumeOptions {
  std::filesystem::path run;  // folder
  bool quiet = false;
  std::optional<std::string> live;  // as in RunOptions
  std::string name;                 // in the stream; empty: as when the run was started
  int threads = 0;                  // as in RunOptions
  std::optional<double> until;      // [s]; empty: as when the run was started
};
/// Continues a run from the newest intact checkpoint of its folder.
int resume(const ResumeOptions& options);
struct CheckOptions {
  std::filesystem::path case_file;
  std::vector<std::string> set;   // key=value
  bool blocks = false;            // print a line for each block
  std::filesystem::path picture;  // of the model; empty: none
  bool names = false;             // of the blocks, in the picture
};
/// Validates a case and prints its contents; the only file written is the picture, if requested.
int check(const CheckOptions& options);
struct DigestOptions {
  std::filesystem::path case_file;
  std::vector<std::string> set;  // key=value
  int threads = 0;               // 0: as many as the machine has
  std::optional<double> until;   // [s]
};
/// Runs a case and prints its motion, one line per frame, to compare two programs. Writes no files.
int digest(const DigestOptions& options);
int cases_list();
/// Names of the cases in the library; empty if no library is found.
[[nodiscard]] std::vector<std::string> case_names();
struct VerifyCommand {
  std::vector<std::string> names;  // empty: all
  Tier tier = Tier::quick;
  int threads = 0;                      // 0: the number that OpenMP chooses
  int jobs = 1;                         // cases at a time, each in a process of its own if there are several
  std::filesystem::path table, report;  // a table as .md, .html, .csv or .json; a folder for tables and plots; or none
};
/// Runs cases and compares them with expected.toml, one row per quantity.
int cases_verify(const VerifyCommand& command);
int schema(bool markdown);

struct WatchOptions {
  std::string source;             // URL, run folder or name of a run; empty: any run on the default URL
  std::string run;                // name of the run to follow; empty: the one that started last
  bool once = false;              // show one screen, then end
  double timeout = 10.0;          // give up after so long without a message [s]; 0: never
  std::optional<double> seconds;  // longest time to watch [s]
};
/// kDone when the run ended or the time is up, kFiles when there is nothing to show, kInterrupted on Ctrl-C.
int watch(const WatchOptions& options);

struct ControlOptions {
  std::string target;     // name of a run that streams on the default URL, its folder, or a URL
  std::string run;        // name of the run, if several stream on that URL
  std::string command;    // pause, resume, step, checkpoint, stop, rate, field
  std::string value;      // step: how many (1); rate: frames per second; field: its name
  double timeout = 10.0;  // for the answer [s]
};
/// kDone when the command was carried out, kFailed when it was refused or failed, kFiles when no run answers.
int control(const ControlOptions& options);

struct ReplayOptions {
  std::filesystem::path run;
  double speed = 1.0;  // simulated seconds per second; 0: as fast as frames can be read and sent
  std::string live;    // URL; empty: the default one
  std::string name;    // of the run in the stream; empty: that of its folder
};
/// kDone when everything was sent, kInterrupted on Ctrl-C.
int replay(const ReplayOptions& options);

struct SnapshotCommand {
  std::filesystem::path run, out;
  std::string at = "end";  // start, end, handover (last stage), a stage, a frame number, a time with the unit s
  std::string field = "displacement", arrows = "none";
  std::vector<double> range, window;  // low, high; x0, y0, x1, y1; empty: from the run
  std::vector<std::string> monitors;  // of the histories; empty: all
  int width = 1680;                   // [pixels]
  bool ledger = false, history = false, labels = false;
  bool elements = false;  // stress as stored, one colour per element
};
int snapshot(const SnapshotCommand& command);

struct ReportCommand {
  std::filesystem::path run, out;  // empty out: report.html in the run folder
  double megabytes = 5.0;          // of the file; 0: every frame, however large
};
/// Writes a stored run as one page of HTML.
int report(const ReportCommand& command);

struct GalleryCommand {
  std::vector<std::string> sources;       // run folders, or names of cases, which are run; empty: all cases of one run
  std::filesystem::path out = "gallery";  // folder; the runs made are in its runs/
  double megabytes = 5.0;                 // of each report
  int threads = 0;                        // 0: as many as the machine has
};
/// Writes a page of many runs with pictures, and the report of each beside it. kFailed if a run cannot be shown.
int gallery(const GalleryCommand& command);

struct SweepCommand {
  std::filesystem::path case_file, table;  // table of parameters; empty: params
  std::vector<std::string> params;         // KEY=A:B:N or KEY=V1,V2,...
  std::filesystem::path out;               // empty: runs/<name of the case>-sweep
  std::size_t jobs = 0;                    // runs at a time; 0: as many as cores allow, with Slurm no limit
  int threads = 1;                         // per run
  std::vector<std::string> set, load;      // of all runs
  std::optional<double> until;             // [s]
  std::vector<std::string> blocks;         // whose displacement is to be in the table
  std::vector<std::string> emit;           // snakemake or gnu-parallel, and the file; empty: make the runs
  std::string on = "local";                // or slurm
  bool no_wait = false;                    // do not wait for the Slurm job
  bool collect = false;                    // only make the table
  std::string only;                        // number of the one run to make; empty: all
  bool quiet = false;
  std::vector<std::string> words;  // of the command line
};
/// Makes the runs of a sweep and their table. kDone where all runs are done, kFailed where some are not, kInterrupted
/// where it was stopped.
int sweep(const SweepCommand& command);

struct SlopeCommand {
  std::optional<double> dip, friction;     // of the plane [deg]
  std::optional<double> weight, length;    // of a block [N/m], of its plane [m]
  double cohesion = 0.0;                   // [Pa]
  double uplift = 0.0, thrust = 0.0;       // of water on a block [N/m]
  std::optional<double> height, face;      // of a slope with a face [m], [deg]
  double unit_weight = 25e3;               // of its rock [N/m3]
  double crack = 0.0, water = 0.0;         // depth of a tension crack, and of the water in it [m]
  double k_h = 0.0, k_v = 0.0;             // pseudo-static
  std::optional<double> yield, pga;        // [g]
  std::optional<double> magnitude, arias;  // [-], [m/s]
  std::vector<std::filesystem::path> records;
  std::string unit;                      // of records that do not state theirs
  double scale = 1.0;                    // of records
  double damping = 0.05;                 // of spectra
  std::filesystem::path json, spectrum;  // files; json may be "-"; empty: none
};
/// Prints pseudo-static, Newmark's and regression numbers of a slope, and facts and spectra of records.
int slope(const SlopeCommand& command);

struct FosCommand {
  std::filesystem::path case_file, out;  // empty out: runs/<name of the case>-fos
  std::vector<std::string> joints;       // laws that are reduced; empty: all
  std::string method, integrator;        // empty: as in the stage to rest
  std::string strength;                  // peak or as-is; empty: peak, and as-is where that differs
  std::string back;                      // phi or c: the only strength changed; empty: all
  double tolerance = 0.01;               // width of the bracket
  double least = 0.1, most = 10.0;       // range of factors
  std::optional<double> time, limit;     // of the dynamic stage [s], displacement limit of the verdict [m]
  double k_h = 0.0;                      // pseudo-static [g]
  std::size_t jobs = 0;                  // runs at a time; 0: as many as cores allow
  int threads = 1;                       // per run
  std::vector<std::string> set, load;    // of all runs
  std::filesystem::path json;            // file, or "-"; empty: only the file in the folder
  bool quiet = false;
  std::vector<std::string> words;  // of the command line
};
/// Finds the factor of safety of a case. kDone where it is found, or shown not to lie between the bounds;
/// kNotConverged where runs stay undecided; kInterrupted where it was stopped.
int fos(const FosCommand& command);

struct ViewOptions {
  std::string source;               // run folder, or case file (.toml); empty with `live`
  std::optional<std::string> live;  // a run that streams; an empty text: on the default URL
  std::string compare;              // a second run folder, to be shown beside the first
  std::string run;                  // name of the run, if several stream on that URL; empty: the one that started last
  std::vector<std::string> set;     // of a case: key=value
  int port = 0;                     // 0: a free one
  bool control = false;             // pages may give commands to a run that streams
  bool open = false;                // in the browser of the desktop
};
/// Serves the page of a run, of a model before its run, or of a run that streams, on this machine alone, until SIGINT,
/// SIGTERM or SIGHUP ends it with kDone.
int view(const ViewOptions& options);

/// Folder of the case library: $SCREE_CASES, else cases/ in the working folder, else that installed with the program,
/// else that of the sources.
[[nodiscard]] std::filesystem::path case_library();

}  // namespace scree::app
