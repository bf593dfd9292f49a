/** Of a page that is written again whenever its file is saved: it is read again while nobody works on it. */
let isWorkedOn = false;
for (const kind of ["pointerdown", "keydown", "blur"]) addEventListener(kind, () => { isWorkedOn = kind !== "blur"; });
setInterval(() => { if (!isWorkedOn) location.reload(); }, 2000);
