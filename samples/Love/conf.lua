function love.conf(t)
  t.version, t.window.title, t.window.width, t.window.height, t.window.msaa, t.modules.audio = "11.4", "Free kick", 960, 540, 4, false
end
