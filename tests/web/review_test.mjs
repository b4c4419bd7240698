// SPDX-License-Identifier: MIT
// Review pages in a headless Chromium, opened from disk: node --test review_test.mjs, started by tests/web/run.
import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, readFileSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, afterEach, before, test } from 'node:test';
import { fileURLToPath, pathToFileURL } from 'node:url';

const source = fileURLToPath(new URL('../..', import.meta.url));
const { WEB_PROGRAM, WEB_NODE, WEB_PICTURES } = process.env;
const { chromium } = createRequire(join(WEB_NODE, 'package.json'))('playwright-core');
const files = mkdtempSync(join(tmpdir(), 'mocapress-review-'));
const sample = (clip) => join(source, 'resources/samples', clip);
const mocapress = (...words) => execFileSync(WEB_PROGRAM, words, { stdio: ['ignore', 'pipe', 'pipe'] });

let browser;
const pages = [];

/** A page from disk whose errors and requests to a server fail the test. */
async function open(path, options = {}) {
  const page = await browser.newPage({ viewport: { width: 1200, height: 1000 }, ...options });
  pages.push(page);
  page.setDefaultTimeout(120_000); // drawing without a graphics card takes all processors
  page.wrong = [];
  page.on('pageerror', (error) => page.wrong.push(String(error)));
  page.on('request', (request) => /^https?:/.test(request.url()) && page.wrong.push(request.url()));
  await page.goto(pathToFileURL(path).href);
  return page;
}

const statusOf = async (page) => {
  await page.waitForFunction(() => document.querySelector('.status')?.textContent.startsWith('Frame'));
  return page.textContent('.status');
};
const errorIn = (status) => Number(/is ([\d.]+) cm off/.exec(status)[1]);
const frameIn = (status) => Number(/^Frame (\d+)/.exec(status)[1]);

/** The share of the middle third of the view that has colours of errors. */
const colouredShare = (page) =>
  page.evaluate(async () => {
    for (let frame = 0; frame < 2; ++frame) await new Promise(requestAnimationFrame);
    const view = document.querySelector('#review canvas');
    const context = new OffscreenCanvas(view.width, view.height).getContext('2d');
    context.drawImage(view, 0, 0);
    const { data } = context.getImageData(view.width / 3, 0, view.width / 3, view.height);
    let coloured = 0;
    for (let i = 0; i < data.length; i += 4)
      coloured += Math.max(data[i], data[i + 1], data[i + 2]) - Math.min(data[i], data[i + 1], data[i + 2]) > 40;
    return coloured / (data.length / 4);
  });

before(async () => {
  mkdirSync(WEB_PICTURES, { recursive: true });
  browser = await chromium.launch({
    executablePath: process.env.WEB_CHROMIUM ?? '/usr/bin/chromium',
    args: ['--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'],
  });
});

// A page that plays takes the time of the next one.
afterEach(() => Promise.all(pages.splice(0).map((page) => page.close())));

after(async () => {
  await browser?.close();
  rmSync(files, { recursive: true });
});

test('a page of one clip shows its worst frames, as far off as the program measured', async () => {
  const path = join(files, 'walk & <run>.html');
  const words = ['compress', sample('human_walk.amc'), '--ratio', '150', '--weighting', 'bone-ends'];
  const measured = JSON.parse(mocapress(...words, '--review', path, '--json'));
  const page = await open(path);
  const worst = await statusOf(page);
  assert.ok(Math.abs(errorIn(worst) - measured.bone_ends_max_cm) < 0.1, `${worst} against ${measured.bone_ends_max_cm}`);
  assert.equal(await page.textContent('#review h2'), 'human_walk.amc');
  assert.deepEqual(await page.locator('[aria-pressed=true]').allTextContents(), ['Overlay', 'Colour by error', 'Follow']);
  await page.screenshot({ path: join(WEB_PICTURES, 'review.png') });
  await page.keyboard.press('n');
  const next = await statusOf(page);
  assert.ok(frameIn(next) !== frameIn(worst) && errorIn(next) <= errorIn(worst));
  await page.keyboard.press('Home');
  assert.equal(frameIn(await statusOf(page)), 1);
  await page.keyboard.press('ArrowRight');
  assert.equal(frameIn(await statusOf(page)), 2);
  await page.keyboard.press('End');
  await page.keyboard.press('r');
  assert.ok((await colouredShare(page)) > 0.01, 'the body is in the middle');
  await page.keyboard.press('Home');
  await page.keyboard.press('ArrowRight');
  const coloured = await colouredShare(page);
  await page.keyboard.press('3');
  const divider = await page.locator('.divider').boundingBox();
  await page.mouse.move(divider.x + divider.width / 2, divider.y + 100);
  await page.mouse.down();
  await page.mouse.move(1100, divider.y + 100);
  await page.mouse.up();
  assert.ok((await colouredShare(page)) < coloured / 10, 'the original is left of the divider');
  await page.keyboard.press('x');
  assert.ok((await colouredShare(page)) > coloured / 2, 'after the swap the compressed body is');
  await page.keyboard.press('x');
  for (const [key, name] of [['2', 'side'], ['3', 'wipe']]) {
    await page.keyboard.press(key);
    await page.waitForTimeout(300);
    await page.screenshot({ path: join(WEB_PICTURES, `review-${name}.png`) });
  }
  await page.keyboard.press(' ');
  await page.waitForFunction(() => !document.querySelector('.status').textContent.startsWith('Frame 2 '));
  assert.deepEqual(page.wrong, []);
  console.log(`a page of one clip: ${statSync(path).size} bytes`);
});

test('the report of a batch loads clips beside it when they are asked for', async () => {
  const clips = ['human_walk', 'human_run'].map((name) => sample(`${name}.amc`));
  const folder = join(files, 'batch');
  mocapress('batch', ...clips, '-o', folder, '--target-error', '0.5', '--review');
  if (spawnSync('xmllint', ['--version']).status === 0)
    execFileSync('xmllint', ['--noout', '--huge', join(folder, 'report.html')]);
  const page = await open(join(folder, 'report.html'));
  assert.equal(await page.isVisible('#review'), false);
  const row = page.locator('#clips tbody tr', { hasText: 'human_run' });
  await row.getByRole('button', { name: 'View' }).click();
  await statusOf(page);
  assert.match(await page.textContent('#review h2'), /human_run/);
  assert.match(await page.textContent('#review p'), /ratio [\d.]+:1 · max [\d.]+ cm/);
  await page.screenshot({ path: join(WEB_PICTURES, 'report.png') });
  assert.deepEqual(page.wrong, []);
  const again = spawnSync(WEB_PROGRAM, ['batch', ...clips, '-o', folder, '--target-error', '0.5', '--review', '--resume']);
  assert.equal(again.status, 0, String(again.stderr));
});

test('notes of reviewers are shown with their clip, and lead to their frames', async () => {
  const folder = join(files, 'noted');
  mkdirSync(folder);
  const clips = ['human_walk', 'human_jump'].map((name) => ({ path: sample(`${name}.amc`) }));
  clips[0].verdict = 'approved';
  clips[1].notes = [{ frame: 30, joint: 'lfoot', text: 'lands hard', reviewer: 'ana' }, { frame: 200, text: 'late' }];
  writeFileSync(join(folder, 'hero.mocapress'), JSON.stringify({ format: 'mocapress-project', version: 1, clips }));
  mocapress('batch', join(folder, 'hero.mocapress'), '-o', folder, '--target-error', '0.5', '--review');
  const page = await open(join(folder, 'report.html'));
  const notes = page.locator('#review .notes button');
  const view = (clip) => page.locator('#clips tbody tr', { hasText: clip }).getByRole('button', { name: 'View' }).click();
  await view('human_jump');
  await statusOf(page);
  assert.deepEqual(await notes.allTextContents(), ['frame 31, lfoot: lands hard (ana)', 'frame 201: late']);
  await notes.first().click();
  assert.equal(frameIn(await statusOf(page)), 31);
  await page.keyboard.press('Shift+M');
  assert.equal(frameIn(await statusOf(page)), 201);
  await page.screenshot({ path: join(WEB_PICTURES, 'noted.png') });
  await view('human_walk');
  await page.waitForFunction(() => document.querySelector('#review h2').textContent.includes('human_walk'));
  assert.match(await page.textContent('#review p'), /verdict approved/);
  assert.equal(await notes.count(), 0);
  assert.deepEqual(page.wrong, []);
});

test('the report of a study shows pictured clips by each method', async () => {
  const folder = join(files, 'study');
  mocapress('study', sample('human_walk.amc'), '-o', folder, '--methods', 'standard,closed-loop', '--ratios', '50');
  const path = join(folder, 'report.html');
  if (spawnSync('xmllint', ['--version']).status === 0) execFileSync('xmllint', ['--noout', '--huge', path]);
  const page = await open(path);
  assert.equal(await page.isVisible('#review'), false);
  const buttons = page.locator('figcaption').getByRole('button', { name: 'View' });
  assert.equal(await buttons.count(), 2);
  await buttons.last().click();
  await statusOf(page);
  assert.match(await page.textContent('#review h2'), /human_walk\.amc, /);
  await page.screenshot({ path: join(WEB_PICTURES, 'study.png') });
  assert.deepEqual(page.wrong, []);
  console.log(`the report of a study: ${statSync(path).size} bytes`);
  const still = await open(path, { javaScriptEnabled: false });
  assert.equal(await still.locator('button').count(), 0);
});

test('pages read without script', async () => {
  const page = await open(join(files, 'batch/report.html'), { javaScriptEnabled: false });
  assert.match(await page.textContent('#clips'), /human_walk/);
  assert.equal(await page.isVisible('#review'), false);
  const one = await open(join(files, 'walk & <run>.html'), { javaScriptEnabled: false });
  assert.match(await one.textContent('body'), /The viewer needs JavaScript/);
});

test('methods that no engine plays are shown too', async () => {
  const path = join(files, 'pca.html');
  const words = ['compress', sample('human_run.amc'), '--method', 'pca', '--ratio', '30', '--review', path, '--json'];
  const measured = JSON.parse(mocapress(...words));
  const page = await open(path);
  const worst = errorIn(await statusOf(page));
  assert.ok(Math.abs(worst - measured.bone_ends_max_cm) < 0.1 + 0.02 * measured.bone_ends_max_cm, `${worst}, ${measured.bone_ends_max_cm}`);
});

test('the report of 3,000 clips is one page below 3 MB', async () => {
  const folder = join(files, 'many');
  mkdirSync(folder);
  const offsets = (i) => Array.from({ length: 4 }, (_, frame) => `${frame + i / 10} 90 0 ${frame} ${i % 7} 0 0 ${frame} 0`);
  for (let i = 0; i < 3000; ++i)
    writeFileSync(
      join(folder, `locomotion_walk_forward_${String(i).padStart(4, '0')}.bvh`),
      `HIERARCHY\nROOT Hips\n{\n OFFSET 0 0 0\n CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation\n` +
        ` JOINT Spine\n {\n  OFFSET 0 20 0\n  CHANNELS 3 Zrotation Xrotation Yrotation\n` +
        `  End Site\n  {\n   OFFSET 0 20 0\n  }\n }\n}\nMOTION\nFrames: 4\nFrame Time: 0.0333333\n${offsets(i).join('\n')}\n`,
    );
  mocapress('batch', folder, '-o', join(files, 'out'), '--target-error', '0.1', '--review');
  const report = join(files, 'out/report.html');
  console.log(`the report of 3,000 clips: ${statSync(report).size} bytes`);
  assert.ok(statSync(report).size < 3e6);
  assert.equal((readFileSync(report, 'utf8').match(/<tr>/g) ?? []).length > 3000, true);
  const began = performance.now();
  const page = await open(report);
  const opened = performance.now();
  const filter = page.getByLabel('name, preset, reason');
  await filter.fill('forward_2999');
  console.log(`opened in ${Math.round(opened - began)} ms, filtered in ${Math.round(performance.now() - opened)} ms`);
  await page.locator('#clips tbody tr', { hasText: 'forward_2999' }).getByRole('button', { name: 'View' }).click();
  await statusOf(page);
  await filter.fill('forward_299');
  const found = await page.locator('#clips tbody th').evaluateAll((heads) => heads.map((head) => head.firstChild.textContent));
  assert.equal(found.length, 10);
  const titleIs = (name) => page.waitForFunction((name) => document.querySelector('#review h2').textContent === name, name);
  await page.locator('#clips tbody tr').first().getByRole('button').click();
  await titleIs(found[0]);
  await page.locator('#review canvas').first().focus();
  await page.keyboard.press('q');
  await titleIs(found[1]);
  assert.match(await page.locator('tr.viewed').textContent(), new RegExp(found[1]));
  await page.keyboard.press('Shift+Q');
  await titleIs(found[0]);
  const neighbour = (name) => page.getByRole('button', { name, exact: true });
  assert.equal(await neighbour('Previous clip').isDisabled(), true);
  assert.equal(await neighbour(`Next clip: ${found[1]}`).isDisabled(), false);
  assert.deepEqual(page.wrong, []);
});
