// One card shows the classic scene from another side.
document.getElementById('turned').camera = { position: [4.5, 1.5, -2.5] };
