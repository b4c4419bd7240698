// SPDX-License-Identifier: MIT
// Files on servers. Every failure is one MocapressError, whose sentence begins with the address.

export class MocapressError extends Error {
  name = 'MocapressError';
}

/** Runs `open`, and puts the address of what it opens before the error that comes out. */
export function named(url, open) {
  try {
    return open();
  } catch (cause) {
    throw new MocapressError(`${url}: ${cause.message}`, { cause });
  }
}

/** Browsers do not tell scripts why a request failed: the reason stands in their consoles. */
export function unreachable(url, cause) {
  const why = 'cannot be fetched: the connection fails, or the server does not let this page read it (CORS)';
  return new MocapressError(`${url}: ${why}`, { cause });
}

export function refused(url, status) {
  return new MocapressError(`${url}: the server answers ${status}`);
}

/** Refuses the pages that many servers send, as if all were well, in place of a file that they lack. */
export function refusePage(url, bytes) {
  if (bytes[0] === '<'.charCodeAt(0)) throw new MocapressError(`${url}: the server sends a page (HTML), not this file`);
  return bytes;
}

/** Bytes of a file, of which there may be none in the range that `options` ask for. */
async function fetchBytes(url, options) {
  try {
    const response = await fetch(url, options);
    if (response.status === 416) return new Uint8Array(0);
    if (!response.ok) throw refused(url, response.status);
    return new Uint8Array(await response.arrayBuffer());
  } catch (error) {
    throw error instanceof MocapressError || options?.signal?.aborted ? error : unreachable(url, error);
  }
}

export async function fetchFile(url, options) {
  return refusePage(url, await fetchBytes(url, options));
}

/**
 * A function that fetches some bytes of a file, which may have fewer. A server that knows no ranges sends the whole
 * file.
 */
export function rangesOf(url, { headers, ...options } = {}) {
  return async (offset, bytes) => {
    const ranged = new Headers(headers);
    ranged.set('Range', `bytes=${offset}-${offset + bytes - 1}`);
    const part = await fetchBytes(url, { ...options, headers: ranged });
    return offset === 0 ? refusePage(url, part) : part;
  };
}

/** As rangesOf(), for parts that the file has, unless it was cut short or changed since its start was fetched. */
export function partsOf(url, options) {
  const fetchRange = rangesOf(url, options);
  return async (offset, bytes) => {
    const part = await fetchRange(offset, bytes);
    if (part.length !== bytes) throw new MocapressError(`${url}: the file is cut short, or not the same any more`);
    return part;
  };
}

/** The name of a file without its folders and extension. */
export function stem(url) {
  return decodeURIComponent(String(url).split(/[?#]/)[0].split('/').pop()).replace(/\.[^.]*$/, '');
}
