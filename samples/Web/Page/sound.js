// The sound of impacts. The library generates the waves; slow motion plays them slowly.
let speaker = null, muted = false, heard = 0;

// Plays the sounds of a ball between two times.
function hear(flown, from, to) {
  flown.sounds.filter(s => s.t > from && s.t <= to).forEach(play);
}

function play({ loudness, brightness, brush, samples }) {
  // A browser allows sound only after the first click, touch or key.
  if (muted || !navigator.userActivation?.hasBeenActive) return;
  speaker ??= new AudioContext();
  const buffer = speaker.createBuffer(1, samples.length, SOUND_RATE), source = speaker.createBufferSource();
  buffer.copyToChannel(samples, 0);
  source.buffer = buffer;
  source.playbackRate.value = rate;
  source.connect(speaker.destination);
  source.start();
  document.body.dataset.heard = JSON.stringify({ sounds: ++heard, loudness, brightness, brush, samples: samples.length });
}

function mute() {
  muted = !muted;
  $("sound").setAttribute("aria-pressed", String(!muted));
  $("sound").textContent = muted ? "🔇" : "🔊";
}
