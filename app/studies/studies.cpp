#include "app/studies/studies.h"

namespace scree::app {

const std::map<std::string, Study>& studies() {
  static const std::map<std::string, Study> kAll{
      {"onefold", onefold}, {"sdof", sdof}, {"sliding", sliding}, {"spring-chain", spring_chain}};
  return kAll;
}

}  // namespace scree::app
