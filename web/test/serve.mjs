// A server of the built app on the loopback, and a browser of the system.
import assert from 'node:assert/strict';
import http from 'node:http';
import { readFile } from 'node:fs/promises';
import { after, before, test } from 'node:test';
import { extname, join, normalize } from 'node:path';
import { chromium } from 'playwright-core';

const TYPES = { '.html': 'text/html', '.js': 'text/javascript', '.css': 'text/css', '.wasm': 'application/wasm', '.svg': 'image/svg+xml', '.webmanifest': 'application/manifest+json' };

export const app = process.env.WEB ?? '../target/app';
export const DESK = { width: 1280, height: 900 };
export const PHONE = { width: 360, height: 740 };

/** Serves a folder; returns its address and what ends it. */
export async function serve(folder) {
  const server = http.createServer(async (request, response) => {
    const asked = normalize(new URL(request.url, 'http://localhost').pathname);
    const path = asked === '/' ? 'index.html' : asked;
    try {
      const body = await readFile(join(folder, path));
      response.writeHead(200, { 'content-type': TYPES[extname(path)] ?? 'application/octet-stream' }).end(body);
    } catch {
      response.writeHead(404).end();
    }
  });
  await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
  return { url: `http://127.0.0.1:${server.address().port}/`, end: () => server.close() };
}

/** The browser. */
export async function browser() {
  if (!process.env.CHROMIUM) throw new Error('there is no Chromium: install it, or name it in CHROMIUM');
  return chromium.launch({ executablePath: process.env.CHROMIUM, args: ['--no-sandbox'] });
}

/** A page with the app, ready; what goes wrong in it, and what it asks of other hosts, is kept. */
export async function open(context, url, hash = '') {
  const page = await context.newPage();
  const faults = [];
  page.on('pageerror', (error) => faults.push(error.message));
  page.on('console', (message) => message.type() === 'error' && faults.push(message.text()));
  page.on('request', (request) => {
    if (!request.url().startsWith(url) && !/^(data|blob):/.test(request.url())) faults.push(`asked ${request.url()}`);
  });
  await page.goto(url + hash);
  await page.waitForSelector('body[data-ready]');
  return { page, faults };
}

/** Tests with a page of the app each; a fault in the page, or a request to another host, fails it. */
export function pages() {
  let server;
  let chromium;
  before(async () => {
    server = await serve(app);
    chromium = await browser();
  });
  after(async () => {
    await chromium?.close();
    server?.end();
  });
  const on = (name, run, options = {}) =>
    test(name, async () => {
      const context = await chromium.newContext({ viewport: DESK, acceptDownloads: true, reducedMotion: 'reduce', ...options });
      const { page, faults } = await open(context, server.url);
      try {
        await run(page, context);
        assert.deepEqual(faults, []);
      } finally {
        await context.close();
      }
    });
  return { on, url: () => server.url, chromium: () => chromium };
}

/** Waits until a change is calculated and drawn: the page has no `data-change` from when it asks until it shows the answer. */
export async function change(page, act) {
  await act();
  await page.waitForSelector('body[data-change]', { state: 'attached' });
}

/** Waits until this holds in the page; where it never does, tells what the page shows. */
export async function until(page, holds, of) {
  try {
    await page.waitForFunction(holds, of, { polling: 50 });
  } catch (error) {
    const shown = await page.evaluate(() => {
      const text = (id) => document.getElementById(id)?.textContent.slice(0, 200);
      return { title: text('title'), refused: text('refused'), notice: text('notice'), file: document.getElementById('text')?.value.slice(0, 600), focus: document.activeElement?.outerHTML.slice(0, 200), state: history.state, address: location.href.slice(0, 60), ...document.body.dataset };
    });
    throw new Error(`${error.message} The page shows ${JSON.stringify(shown, null, 2)}`);
  }
}
