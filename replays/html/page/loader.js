'use strict';
// Unpacks the viewer, which the page contains in deflated form, and runs it. The page's security policy
// allows only scripts with the named digests.
addEventListener('DOMContentLoaded', async () => {
  const message = document.getElementById('message');
  const packed = document.getElementById('viewer');
  const meta = document.getElementById('meta');
  if (typeof DecompressionStream !== 'function') {
    message.textContent = 'This browser is too old to unpack the replay: Chrome 103, Firefox 113 or Safari 16.4 can. What was recorded, without the positions:';
    const text = document.createElement('pre');
    text.textContent = meta ? meta.textContent : '';
    message.after(text);
    return;
  }
  try {
    const bytes = Uint8Array.from(atob(packed.textContent), (c) => c.charCodeAt(0));
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate-raw'));
    const script = document.createElement('script');
    script.textContent = await new Response(stream).text();
    document.head.append(script);
  } catch {
    message.textContent = 'The file is incomplete or damaged: even its viewer cannot be read. Ask for it again.';
    document.body.dataset.failed = 'true';
  }
});
