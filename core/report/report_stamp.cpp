// SPDX-License-Identifier: MIT
#include "core/report/report_stamp.h"

#include "core/base/utc_time.h"

namespace mocapress {

ReportStamp report_stamp() {
  return {"Mocapress " MOCAPRESS_VERSION, utc_text(report_time())};
}

}  // namespace mocapress
