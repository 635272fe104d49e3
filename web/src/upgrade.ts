// The service worker, and a newer version of the app when there is one.

/** Registers the service worker. A newer version takes over before anything is done in the page; else when the person wants it. */
export function upgrades(notify: (message: string, actions: [label: string, act: () => void][]) => void): void {
  if (!('serviceWorker' in navigator) || !location.protocol.startsWith('http')) return;
  const workers = navigator.serviceWorker;
  // The first one comes to a page that is as new as it is.
  const hadOne = workers.controller !== null;
  let isTouched = false;
  for (const kind of ['pointerdown', 'keydown', 'input']) addEventListener(kind, () => (isTouched = true), { once: true, capture: true });

  // Files of two versions do not go together. What is shown outlives a reload.
  workers.addEventListener('controllerchange', () => hadOne && location.reload());

  const ready = (waiting: ServiceWorker) => {
    const take = () => waiting.postMessage('take over');
    if (!isTouched) return take();
    notify('A newer version of the app is here. What you have entered is kept when the page is loaded again.', [['Load it', take]]);
  };
  void workers.register('sw.js', { updateViaCache: 'none' }).then((registration) => {
    if (!hadOne) return;
    const watch = () => {
      const coming = registration.installing;
      coming?.addEventListener('statechange', () => coming.state === 'installed' && ready(coming));
    };
    if (registration.waiting) ready(registration.waiting);
    watch();
    registration.addEventListener('updatefound', watch);
  }, () => undefined);
}
