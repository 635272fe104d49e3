// Keeps the files of the app, so that it opens without a network.
declare const FILES: string[];
declare const VERSION: string;

const worker = self as unknown as ServiceWorkerGlobalScope;
const kept = `epicyclic-${VERSION}`;

worker.addEventListener('install', (event) => {
  event.waitUntil(
    caches
      .open(kept)
      // As the server has them now, not as a cache of the browser has kept them.
      .then((cache) => cache.addAll(FILES.map((file) => new Request(file, { cache: 'reload' })))),
  );
});

// Pages of the version before may be open: a newer one waits until one of them asks for it.
worker.addEventListener('message', ({ data }) => {
  if (data === 'take over') void worker.skipWaiting();
});

worker.addEventListener('activate', (event) => {
  event.waitUntil(
    caches
      .keys()
      .then((names) => Promise.all(names.filter((other) => other.startsWith('epicyclic-') && other !== kept).map((other) => caches.delete(other))))
      .then(() => worker.clients.claim()),
  );
});

worker.addEventListener('fetch', (event) => {
  if (event.request.method !== 'GET' || new URL(event.request.url).origin !== worker.location.origin) return;
  // The file that the program was given is its own to tell, never kept: the page asks for it without the worker.
  if (event.request.url.endsWith('/opened')) return;
  event.respondWith(caches.match(event.request, { ignoreSearch: true, cacheName: kept }).then((found) => found ?? fetch(event.request)));
});

export {};
