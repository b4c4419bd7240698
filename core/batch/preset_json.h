// SPDX-License-Identifier: MIT
#pragma once

#include "core/batch/preset.h"
#include "core/mocapress/settings_json.h"
