#include "io/case/read_case.h"

#include "io/case/check_document.h"
#include "io/case/data_file.h"
#include "io/case/guard.h"
#include "io/case/override.h"
#include "io/case/read_parts.h"
#include "io/case/text_file.h"
#include "model/local_origin.h"

namespace scree::io {

Case read_case(const std::filesystem::path& file, const std::vector<std::string>& overrides,
               std::span<const std::string> methods, const Notice& notice) {
  return read_case_text(read_text_file(file, "case file", kLargestCase), file, overrides, methods, notice);
}

Case read_case_text(std::string text, const std::filesystem::path& file, const std::vector<std::string>& overrides,
                    std::span<const std::string> methods, const Notice& notice) {
  Case out;
  out.text = std::move(text);
  out.path = file.string();
  out.overrides = overrides;
  guard(out.text, out.path);
  Value document = parse_document(out.text, out.path);
  apply_overrides(document, overrides);
  check_document(document, out.path);

  out.files = data_files(document, file.parent_path());

  const Section root(out.path, document, "");
  const DrawnLayers drawing = root.has("drawing") ? DrawnLayers(root, file.parent_path()) : DrawnLayers();
  read_laws(root, out.model);
  read_functions(root, file.parent_path(), out.model);
  read_blocks(root, file.parent_path(), drawing, out.model, notice);
  read_cracks(root, out.model);
  read_motions(root, file.parent_path(), out.model);
  read_supports(root, out.model);
  read_loads(root, out.model);
  read_bolts(root, drawing, out.model);
  read_water(root, drawing, out.model);
  read_monitors(root, drawing, out.model);
  out.plan = read_plan(root, out.model, methods);
  read_free_fields(root, out.plan, out.model);
  read_liners(root, out.plan.stages, out.model);
  out.live_field = root.table("live").text("field");
  check_times(root, out.model, out.plan);
  check_meshes(root, out.model, out.plan);
  read_reduction(root, methods, out.model, out.plan);
  out.resolved = to_toml(document);
  if (!drawing.empty()) out.drawing = drawing.report();
  move_to_local_origin(out.model);  // last: errors above report coordinates of the file
  for (coupling::Stage& stage : out.plan.stages)
    for (Vec2& corner : stage.partition.explicit_region) corner -= out.model.origin;
  return out;
}

}  // namespace scree::io
