#!/usr/bin/env python3
"""A client of the league's simulator: its robots chase the ball and drive it toward the other goal.

First make the messages, once:

    protoc --proto_path=bridge/wire --python_out=FOLDER simulator.proto referee.proto

Then start it beside a server (fulbito serve), with FOLDER in PYTHONPATH:

    python3 chaser_client.py yellow --interface 127.0.0.1
"""

import argparse
import math
import select
import socket
import struct

import referee_pb2
import simulator_pb2

VISION_GROUP = "224.0.0.1"
REFEREE_GROUP = "224.5.23.2"
CRUISE = 25.0  # [rad/s] of the wheels
TURN = 12.0  # [rad/s] of the wheels per radian


def arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description="A client that chases the ball.")
    parser.add_argument("colour", choices=["blue", "yellow"])
    parser.add_argument("--host", default="127.0.0.1", help="machine of the server")
    parser.add_argument("--port-base", type=int, default=10002, help="port of vision; the others follow from it")
    parser.add_argument("--interface", default="0.0.0.0", help="address of the interface for multicast")
    return parser.parse_args()


def listen(group: str, port: int, interface: str) -> socket.socket:
    """A socket that hears a multicast group."""
    listener = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    listener.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    listener.bind((group, port))
    membership = struct.pack("4s4s", socket.inet_aton(group), socket.inet_aton(interface))
    listener.setsockopt(socket.IPPROTO_IP, socket.IP_ADD_MEMBERSHIP, membership)
    return listener


def newest(listener: socket.socket) -> bytes:
    """The last datagram that waits: a client that falls behind skips frames."""
    data = listener.recv(1024)
    while select.select([listener], [], [], 0)[0]:
        data = listener.recv(1024)
    return data


def wheels_toward(robot: simulator_pb2.Robot, x: float, y: float) -> tuple[float, float]:
    """Wheel speeds that lead to a point, with either end of the robot in front."""
    error = math.remainder(math.atan2(y - robot.y, x - robot.x) - robot.orientation, 2.0 * math.pi)
    speed = CRUISE
    if abs(error) > math.pi / 2:
        error = math.remainder(error + math.pi, 2.0 * math.pi)
        speed = -CRUISE
    return speed * math.cos(error) - TURN * error, speed * math.cos(error) + TURN * error


def commands(seen: simulator_pb2.Environment, yellow: bool, playing: bool) -> simulator_pb2.Packet:
    """A command for each robot of the team."""
    packet = simulator_pb2.Packet()
    forward = -1.0 if yellow else 1.0
    ball = seen.frame.ball
    for robot in seen.frame.robots_yellow if yellow else seen.frame.robots_blue:
        command = packet.cmd.robot_commands.add(id=robot.robot_id, yellowteam=yellow)
        if not playing:
            continue
        if robot.robot_id == 0:  # the keeper moves along its line
            x, y = -0.68 * forward, max(-0.15, min(0.15, ball.y))
        elif (ball.x - robot.x) * forward > 0.05:  # behind the ball: through it
            x, y = ball.x + 0.05 * forward, ball.y
        else:  # back behind the ball, around it
            x, y = ball.x - 0.2 * forward, ball.y + (0.12 if robot.y > ball.y else -0.12)
        command.wheel_left, command.wheel_right = wheels_toward(robot, x, y)
    return packet


def placement(yellow: bool) -> referee_pb2.VSSRef_Placement:
    """Where the robots wish to stand at a restart; the referee repairs what its rules do not allow."""
    message = referee_pb2.VSSRef_Placement()
    message.world.teamColor = referee_pb2.YELLOW if yellow else referee_pb2.BLUE
    side = 1.0 if yellow else -1.0
    for number, (x, y) in enumerate([(0.68, 0.0), (0.35, 0.1), (0.35, -0.25)]):
        message.world.robots.add(robot_id=number, x=side * x, y=y, orientation=180.0 if yellow else 0.0)
    return message


def main() -> None:
    given = arguments()
    yellow = given.colour == "yellow"
    vision = listen(VISION_GROUP, given.port_base, given.interface)
    referee = listen(REFEREE_GROUP, given.port_base + 1, given.interface)
    sender = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    if given.interface != "0.0.0.0":
        sender.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_IF, socket.inet_aton(given.interface))
    foul = referee_pb2.HALT
    played = False
    while True:
        ready = select.select([vision, referee], [], [])[0]
        if referee in ready:
            # Each command counts, so none is skipped.
            told = referee_pb2.VSSRef_Command.FromString(referee.recv(1024))
            if told.foul < referee_pb2.STOP:
                sender.sendto(placement(yellow).SerializeToString(), (REFEREE_GROUP, given.port_base + 2))
            foul = told.foul
            played = played or foul == referee_pb2.GAME_ON
            if foul == referee_pb2.HALT and played:
                break  # the match is over
        if vision in ready:
            seen = simulator_pb2.Environment.FromString(newest(vision))
            packet = commands(seen, yellow, foul == referee_pb2.GAME_ON)
            sender.sendto(packet.SerializeToString(), (given.host, given.port_base + 10009))


if __name__ == "__main__":
    try:
        main()
    except KeyboardInterrupt:
        pass
