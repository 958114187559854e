# A free kick over a wall. Click on the goal to kick, right-click to put the ball back, and hold the space bar for slow motion.
# godot --headless --path samples/GDExtension/demo -- --kick    kicks once and prints: hash 7f18c6acbe515461
extends Node3D

const SPEED := 24.0

@onready var ball: FootballBall = $Ball
@onready var label: Label = $Label
@onready var path: MeshInstance3D = $Path

var goals := 0
var steps_left := -1


func _ready() -> void:
	path.mesh = ImmediateMesh.new()
	box(Vector3(0, -0.05, -10), Vector3(60, 0.1, 60), Color(0.2, 0.5, 0.2))
	box(Vector3(1, 0.92, -9.15), Vector3(2.6, 1.84, 0.4), Color(0.8, 0.2, 0.2))
	for side in [-1, 1]:
		box(Vector3(3.72 * side, 1.25, -22), Vector3(0.12, 2.5, 0.12), Color.WHITE)
	box(Vector3(0, 2.5, -22), Vector3(7.56, 0.12, 0.12), Color.WHITE)
	ball.impact.connect(func(_position, before, _velocity, _spin, _time, surface): say("Hit the %s at %.0f m/s." % [surface, before.length()]))
	ball.goal.connect(func(_position, _velocity, time):
		goals += 1
		say("Goal number %d, %.2f s after the kick!" % [goals, time]))
	ball.rest.connect(func(_position, _time): say("The ball rests."))
	if "--kick" in OS.get_cmdline_user_args():
		ball.scene = null
		ball.place(Vector3.ZERO)
		ball.kick_with(Vector3(3, 8, -22), Vector3(0, 40, 0))
		steps_left = 120


func _physics_process(_delta: float) -> void:
	# The parent is processed before the ball.
	if steps_left == 0:
		print("hash ", ball.hash())
		get_tree().quit()
	steps_left -= 1


func _process(_delta: float) -> void:
	Engine.time_scale = 0.3 if Input.is_key_pressed(KEY_SPACE) else 1.0
	var points := ball.path_ahead(120)
	path.mesh.clear_surfaces()
	if points.size() < 2:
		return
	path.mesh.surface_begin(Mesh.PRIMITIVE_LINE_STRIP)
	for point in points:
		path.mesh.surface_add_vertex(point)
	path.mesh.surface_end()


func _unhandled_input(event: InputEvent) -> void:
	if not event is InputEventMouseButton or not event.pressed:
		return
	ball.place(Vector3.ZERO)
	if event.button_index == MOUSE_BUTTON_LEFT:
		var camera := get_viewport().get_camera_3d()
		var target := camera.project_position(event.position, camera.global_position.z + 22.0)
		# The ball falls and bends to the left, so aim higher and to the right.
		var direction := (target - ball.global_position + Vector3(3.8, 6.0, 0)).normalized()
		ball.kick(SPEED, direction, 0.0, 45.0)


func say(text: String) -> void:
	label.text = text


func box(center: Vector3, size: Vector3, color: Color) -> void:
	var mesh := BoxMesh.new()
	mesh.size = size
	mesh.material = StandardMaterial3D.new()
	mesh.material.albedo_color = color
	var node := MeshInstance3D.new()
	node.mesh = mesh
	node.position = center
	add_child(node)
