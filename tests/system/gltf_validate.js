// SPDX-License-Identifier: MIT
// Prints the Khronos validator's errors and warnings for some glTF files, one a line.
// Usage: NODE_PATH=... node gltf_validate.js FILE...
const fs = require("fs");
const path = require("path");
const validator = require("gltf-validator");

async function main() {
  for (const file of process.argv.slice(2)) {
    const report = await validator.validateBytes(new Uint8Array(fs.readFileSync(file)), {
      externalResourceFunction: (uri) =>
        fs.promises.readFile(path.join(path.dirname(file), decodeURIComponent(uri)))
          .then((bytes) => new Uint8Array(bytes)),
    });
    for (const issue of report.issues.messages)
      if (issue.severity < 2)
        console.log(`${path.basename(file)}: ${issue.code} ${issue.pointer}: ${issue.message}`);
  }
}

main();
